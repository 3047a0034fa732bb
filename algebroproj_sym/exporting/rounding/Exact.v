(** The exact value of a program is a formula: both are rational functions, and Coq multiplies them out. *)

From Coq Require Import Reals ZArith NArith QArith PArith List Bool Lia Lra.
From Flocq Require Import IEEE754.BinarySingleNaN.
From Algebroproj Require Import Rounding Checker Ranges Machine Instances.
From Algebroproj Require Formulas.

Import ListNotations.
Open Scope R_scope.

(** How divisors split into factors, by the number of the quotient. *)
Definition splits := list (positive * (Q * list Z)).

Definition split_of (s : splits) (i : positive) : Q * list Z :=
  match find (fun named => Pos.eqb (fst named) i) s with Some named => snd named | None => (1%Q, []) end.

(** Operations as trees: of [n] arguments, and of the values of earlier operations. *)
Section Trees.

Variables (n : nat) (s : splits).

Definition place (j : positive) : nat := (n + Nat.pred (Pos.to_nat j))%nat.
Definition variable (j : positive) : Formulas.expr := Formulas.Var (place j).

Definition tree (i : positive) (o : operation) : Formulas.expr :=
  match o with
  | Input k => Formulas.Var (Nat.pred (Pos.to_nat k))
  | Constant z => Formulas.Int z
  | Neg a => Formulas.Opp (variable a)
  | Add a b | Join a b => Formulas.Add (variable a) (variable b)
  | Sub a b => Formulas.Sub (variable a) (variable b)
  | Mul a b => Formulas.Mul (variable a) (variable b)
  | Div a b => Formulas.Div (variable a) (variable b) (fst (split_of s i)) (snd (split_of s i))
  | ProductError a b p => Formulas.Sub (Formulas.Mul (variable a) (variable b)) (variable p)
  end.

Definition trees (p : program) : list Formulas.expr := map (fun named => tree (fst named) (snd named)) p.

(** Operations are numbered without gaps, and take arguments that there are. *)
Fixpoint consecutive (i : positive) (p : program) : bool :=
  match p with
  | [] => true
  | (j, o) :: q =>
      Pos.eqb i j && forallb (fun a => (a <? i)%positive) (operands o)
      && match o with Input k => (Nat.pred (Pos.to_nat k) <? n)%nat | _ => true end && consecutive (Pos.succ i) q
  end.

Variable xs : list R.
Hypothesis xs_length : length xs = n.

Definition follows (i : positive) (env : list R) (e : values) : Prop :=
  length env = place i
  /\ (forall k, (k < n)%nat -> nth k env 0 = nth k xs 0)
  /\ (forall j, (j < i)%positive -> nth (place j) env 0 = e j).

Lemma tree_value i env e o :
  follows i env e -> (forall a, In a (operands o) -> (a < i)%positive) ->
  match o with Input k => (Nat.pred (Pos.to_nat k) < n)%nat | _ => True end ->
  Formulas.eval env (tree i o) = value (numbers xs) e o.
Proof.
  intros (_ & X & E) O I. destruct o; simpl in *; rewrite ?E by (apply O; simpl; auto); try reflexivity. now apply X.
Qed.

Lemma trees_run p : forall i env e,
  follows i env e -> consecutive i p = true ->
  (forall k, (k < n)%nat -> nth k (Formulas.run env (trees p)) 0 = nth k xs 0)
  /\ (forall j, (j < i)%positive \/ In j (map fst p) -> nth (place j) (Formulas.run env (trees p)) 0 = run (value (numbers xs)) p e j).
Proof.
  induction p as [|[j o] q IH]; intros i env e F C.
  - destruct F as (_ & X & E). split; [exact X|]. intros j [J | []]. now apply E.
  - simpl in C. apply andb_prop in C as [C Cq]. apply andb_prop in C as [C Ci]. apply andb_prop in C as [Cj Co].
    apply Pos.eqb_eq in Cj. subst j. rewrite forallb_forall in Co.
    assert (V := tree_value i env e o F (fun a A => proj1 (Pos.ltb_lt _ _) (Co a A))).
    assert (I : match o with Input k => (Nat.pred (Pos.to_nat k) < n)%nat | _ => True end)
      by (destruct o; try exact I; now apply Nat.ltb_lt).
    specialize (V I). destruct F as (L & X & E). simpl. rewrite V.
    destruct (IH (Pos.succ i) (env ++ [value (numbers xs) e o])
      (fun j => if Pos.eqb j i then value (numbers xs) e o else e j)) as (IX & IE); [|exact Cq|].
    + split; [|split].
      * rewrite app_length, L. unfold place. simpl. lia.
      * intros k K. rewrite app_nth1 by (rewrite L; unfold place; lia). now apply X.
      * intros j J. destruct (Pos.eqb_spec j i) as [-> | N].
        -- rewrite app_nth2 by lia. now rewrite L, Nat.sub_diag.
        -- rewrite app_nth1 by (rewrite L; unfold place; lia). apply E. lia.
    + split; [exact IX|]. intros j [J | [<- | J]]; apply IE; [left; lia | left; lia | now right].
Qed.

End Trees.

(** A tree of the first [n] variables alone. *)
Fixpoint closed (n : nat) (e : Formulas.expr) : bool :=
  match e with
  | Formulas.Int _ => true
  | Formulas.Var k => (k <? n)%nat
  | Formulas.Opp a | Formulas.Pow a _ | Formulas.Abs a | Formulas.Floor a => closed n a
  | Formulas.Add a b | Formulas.Sub a b | Formulas.Mul a b | Formulas.Div a b _ _ | Formulas.Compare a b =>
      closed n a && closed n b
  end.

Lemma closed_value n env xs e :
  (forall k, (k < n)%nat -> nth k env 0 = nth k xs 0) -> closed n e = true -> Formulas.eval env e = Formulas.eval xs e.
Proof.
  intros X. induction e; simpl; intros C; try (apply andb_prop in C as [C1 C2]);
    rewrite ?IHe, ?IHe1, ?IHe2 by assumption; try reflexivity. now apply X, Nat.ltb_lt.
Qed.

Definition equation (n : nat) (named : positive * Formulas.expr) : Formulas.goal :=
  Formulas.Equation (variable n (fst named)) (snd named) 1 [] [].

Definition is_formula (n : nat) (p : program) (s : splits) (divisors : list Formulas.expr)
  (results : list positive) (formulas : list Formulas.expr) : bool :=
  consecutive n 1 p && forallb (closed n) formulas && (length results =? length formulas)%nat
  && forallb (fun j => existsb (Pos.eqb j) (map fst p)) results
  && Formulas.decided n 0 divisors [] [] [] (trees n s p) (map (equation n) (combine results formulas)).

Theorem is_formula_sound xs p s divisors results formulas :
  is_formula (length xs) p s divisors results formulas = true ->
  Formulas.all (map (fun d => Formulas.eval xs d <> 0) divisors) ->
  map (exact (numbers xs) p) results = map (Formulas.eval xs) formulas.
Proof.
  intros H D. unfold is_formula in H. apply andb_prop in H as [H H5]. apply andb_prop in H as [H H4].
  apply andb_prop in H as [H H3]. apply andb_prop in H as [H1 H2]. apply Nat.eqb_eq in H3.
  assert (G := Formulas.follows xs [] divisors [] [] [] (trees (length xs) s p) _ H5 D I I I).
  rewrite app_nil_r, Formulas.all_map, Forall_map in G.
  destruct (trees_run (length xs) s xs eq_refl p 1 xs nothing) as (X & E); [|exact H1|].
  { split; [unfold place; simpl; lia | split; [reflexivity | lia]]. }
  set (env := Formulas.run xs (trees (length xs) s p)) in *. clearbody env. clear H5 D.
  revert formulas H2 H3 G. induction results as [|r results IH]; intros [|f formulas] H2 H3 G; try discriminate; [reflexivity|].
  simpl in H2, H3, H4, G |- *. apply andb_prop in H2 as [H2 H2']. apply andb_prop in H4 as [H4 H4'].
  inversion G as [|? ? G1 G2]; subst. f_equal; [|apply IH; auto].
  simpl in G1. rewrite <- (closed_value _ env xs f X H2), <- G1. symmetry. apply E. right.
  apply existsb_exists in H4 as (j & J & Q). apply Pos.eqb_eq in Q. now subst.
Qed.

(** Factors that are not zero at integers. *)
Definition nonzero_at (integers : list Z) (factors : list Formulas.expr) : bool :=
  forallb (fun z => (Z.abs z <=? 2 ^ 53)%Z) integers
  && forallb (fun d => Formulas.holds (map inject_Z integers) (Formulas.Nonzero d)) factors.

Lemma nonzero_at_sound integers factors :
  nonzero_at integers factors = true ->
  Formulas.all (map (fun d => Formulas.eval (map B2R (map machine_integer integers)) d <> 0) factors).
Proof.
  intros H. apply andb_prop in H as [S H]. rewrite forallb_forall in S, H. apply Formulas.all_map, Forall_forall.
  intros d D. refine (Formulas.holds_sound _ _ _ (Formulas.Nonzero d) (H d D)). intros k q K.
  rewrite nth_error_map in K. destruct (nth_error integers k) as [z|] eqn:E; [|discriminate]. injection K as <-.
  assert (M := machine_integer_holds z (proj1 (Z.leb_le _ _) (S z (nth_error_In _ _ E)))).
  rewrite map_map, Formulas.Q2R_Z. rewrite <- (proj2 M). apply (map_nth_error (fun n => B2R (machine_integer n))) in E.
  now apply nth_error_nth.
Qed.
