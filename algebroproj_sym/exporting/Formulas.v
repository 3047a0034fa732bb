(** Rational formulas over the reals, decided by computing in the kernel.

    A theorem of the exported files states equations between real numbers in ordinary notation.  Its proof names the
    same formulas as trees of type [expr], and the lemma [follows] or [computed] below reduces the theorem to a
    computation with polynomials over Q, or with rational numbers.  Everything here is proved; a reader of a theorem
    needs to believe none of it. *)

From Coq Require Import Reals QArith Qreals Qabs Qround List ZArith Lia Lra.
From Coq Require Import BinList Ring_theory Ring_polynom.
From Algebroproj Require Export Elimination.
Import ListNotations.
Open Scope R_scope.

(** * Formulas and what they say *)

(** The largest integer that is not greater; and 1 if a is at most b, else 0. *)
Definition floor (x : R) : R := IZR (Int_part x).
Definition at_most (a b : R) : R := if Rle_dec a b then 1 else 0.

(** [Div a b c h]: the numerator of b is c times the product of the divisors with the exponents h.  The last three
    operations are for numbers alone. *)
Inductive expr : Type :=
| Int (n : Z)
| Var (k : nat)
| Opp (a : expr)
| Add (a b : expr)
| Sub (a b : expr)
| Mul (a b : expr)
| Div (a b : expr) (c : Q) (h : list Z)
| Pow (a : expr) (n : nat)
| Abs (a : expr)
| Floor (a : expr)
| Compare (a b : expr).

Fixpoint eval (env : list R) (e : expr) : R :=
  match e with
  | Int n => IZR n
  | Var k => List.nth k env 0
  | Opp a => - eval env a
  | Add a b => eval env a + eval env b
  | Sub a b => eval env a - eval env b
  | Mul a b => eval env a * eval env b
  | Div a b _ _ => eval env a / eval env b
  | Pow a n => eval env a ^ n
  | Abs a => Rabs (eval env a)
  | Floor a => floor (eval env a)
  | Compare a b => at_most (eval env a) (eval env b)
  end.

(** The environment with the values of definitions, each in terms of those before it. *)
Fixpoint run (env : list R) (definitions : list expr) : list R :=
  match definitions with [] => env | d :: rest => run (env ++ [eval env d]) rest end.

Inductive literal : Type :=
| Zero (a : expr)
| Nonzero (a : expr)
| Equal (a b : expr)
| Unequal (a b : expr)
| Less (a b : expr)
| AtMost (a b : expr)
| Regular (rows : list (list expr)).

Definition says (env : list R) (l : literal) : Prop :=
  match l with
  | Zero a => eval env a = 0
  | Nonzero a => eval env a <> 0
  | Equal a b => eval env a = eval env b
  | Unequal a b => eval env a <> eval env b
  | Less a b => eval env a < eval env b
  | AtMost a b => eval env a <= eval env b
  | Regular rows => regular_matrix (map (map (eval env)) rows)
  end.

Fixpoint all (props : list Prop) : Prop :=
  match props with
  | [] => True
  | [p] => p
  | p :: rest => p /\ all rest
  end.

Lemma all_cons p rest : all (p :: rest) <-> p /\ all rest.
Proof. destruct rest; simpl; tauto. Qed.

Lemma all_map {A} (f : A -> Prop) (l : list A) : all (map f l) <-> Forall f l.
Proof.
  induction l as [|a l IH]; [simpl; split; auto|].
  cbn [map]. rewrite all_cons, IH. split; [intros []; now constructor|inversion 1; tauto].
Qed.

(** Names of subterms: the k-th variable after the first [n] is the value of the k-th definition. *)
Fixpoint defined (env : list R) (n : nat) (definitions : list expr) : list Prop :=
  match definitions with
  | [] => []
  | d :: rest => (List.nth n env 0 = eval env d) :: defined env (S n) rest
  end.

(** * Readers of formulas: what is read of definitions, one after the other *)

(** The entries of an environment may depend on a parameter, such as the time.  [means f a] says what [a] is of [f]. *)
Section Readers.
Variables T A : Type.
Variable reader : list A -> expr -> option A.
Variable means : (T -> R) -> A -> Prop.
Hypothesis means_same : forall f g a, (forall t, f t = g t) -> means f a -> means g a.

Definition entries_mean (env : T -> list R) (values : list A) : Prop :=
  forall k a, nth_error values k = Some a -> means (fun t => List.nth k (env t) 0) a.
Hypothesis reads_well : forall env values, entries_mean env values ->
  forall e a, reader values e = Some a -> means (fun t => eval (env t) e) a.

Fixpoint extended (values : list A) (definitions : list expr) : option (list A) :=
  match definitions with
  | [] => Some values
  | d :: rest => match reader values d with Some a => extended (values ++ [a]) rest | None => None end
  end.

Lemma one_more (before env : T -> list R) values d a : entries_mean before values -> reader values d = Some a ->
  (forall k t, (k < length values)%nat -> List.nth k (env t) 0 = List.nth k (before t) 0) ->
  (forall t, List.nth (length values) (env t) 0 = eval (before t) d) -> entries_mean env (values ++ [a]).
Proof.
  intros F E Old New k b H. destruct (Nat.lt_ge_cases k (length values)) as [L|L].
  - rewrite nth_error_app1 in H by assumption. apply F in H. revert H. apply means_same. intro t. now rewrite Old.
  - rewrite nth_error_app2 in H by assumption. destruct (k - length values)%nat as [|j] eqn:K; [|destruct j; discriminate].
    simpl in H. injection H as <-. replace k with (length values) by lia.
    apply (reads_well _ _ F) in E. revert E. apply means_same. intro t. now rewrite New.
Qed.

Lemma extended_defined env definitions : forall values more, entries_mean env values ->
  extended values definitions = Some more -> (forall t, all (defined (env t) (length values) definitions)) ->
  entries_mean env more.
Proof.
  induction definitions as [|d rest IH]; cbn [extended defined]; intros values more F E D; [now injection E as <-|].
  destruct (reader values d) as [a|] eqn:N; [|discriminate].
  apply IH with (values ++ [a])%list; [|assumption|].
  - apply (one_more env env values d a); [assumption|assumption|reflexivity|].
    intro t. specialize (D t). rewrite all_cons in D. apply D.
  - intro t. specialize (D t). rewrite all_cons in D. rewrite app_length, Nat.add_comm. apply D.
Qed.

(** The same of terms that a proof shares: their values are appended to the environment. *)
Lemma extended_run shared : forall env values more, (forall t, length (env t) = length values) ->
  entries_mean env values -> extended values shared = Some more -> entries_mean (fun t => run (env t) shared) more.
Proof.
  induction shared as [|d rest IH]; cbn [extended run]; intros env values more L F E; [now injection E as <-|].
  destruct (reader values d) as [a|] eqn:N; [|discriminate].
  apply (IH (fun t => env t ++ [eval (env t) d])%list (values ++ [a])%list); [intro t; now rewrite !app_length, L| |assumption].
  apply (one_more env _ values d a); [assumption|assumption| |].
  - intros k t K. apply app_nth1. now rewrite L.
  - intro t. rewrite <- (L t), app_nth2 by apply le_n. now rewrite Nat.sub_diag.
Qed.

Lemma extended_length definitions : forall values more,
  extended values definitions = Some more -> length more = (length values + length definitions)%nat.
Proof.
  induction definitions as [|d rest IH]; cbn [extended]; intros values more E; [injection E as <-; simpl; lia|].
  destruct (reader values d); [|discriminate]. apply IH in E. rewrite E, app_length. simpl. lia.
Qed.
End Readers.
Arguments extended {A}.

(** The same where nothing depends on a parameter, and what is read is a number. *)
Section Numbers.
Variable A : Type.
Variable reader : list A -> expr -> option A.
Variable real : A -> R.
Definition stands (env : list R) (values : list A) : Prop :=
  entries_mean unit A (fun f a => f tt = real a) (fun _ => env) values.
Hypothesis reads_well : forall env values, stands env values -> forall e a, reader values e = Some a -> eval env e = real a.

Lemma defined_stands env definitions values more : stands env values -> extended reader values definitions = Some more ->
  all (defined env (length values) definitions) -> stands env more.
Proof.
  intros F E D. refine (extended_defined _ _ _ _ _ (fun env => reads_well (env tt)) _ _ _ _ F E (fun _ => D)).
  now intros f g a <-.
Qed.

Lemma run_stands env shared values more : length env = length values -> stands env values ->
  extended reader values shared = Some more -> stands (run env shared) more.
Proof.
  intros L F E. refine (extended_run _ _ _ _ _ (fun env => reads_well (env tt)) _ (fun _ => env) _ _ (fun _ => L) F E).
  now intros f g a <-.
Qed.
End Numbers.

(** * Polynomials over Q *)

Definition qadd (a b : Q) : Q := Qred (a + b).
Definition qsub (a b : Q) : Q := Qred (a - b).
Definition qmul (a b : Q) : Q := Qred (a * b).


Lemma Q2R_0 : Q2R 0 = 0.
Proof. unfold Q2R; simpl; lra. Qed.
Lemma Q2R_1 : Q2R 1 = 1.
Proof. unfold Q2R; simpl; lra. Qed.

Lemma real_morphism : ring_morph 0 1 Rplus Rmult Rminus Ropp (@eq R) 0%Q 1%Q qadd qmul qsub Qopp Qeq_bool Q2R.
Proof.
  constructor; intros; unfold qadd, qsub, qmul; rewrite ?(Qeq_eqR _ _ (Qred_correct _)).
  - exact Q2R_0.
  - exact Q2R_1.
  - apply Q2R_plus.
  - apply Q2R_minus.
  - apply Q2R_mult.
  - apply Q2R_opp.
  - now apply Qeq_eqR, Qeq_bool_iff.
Qed.

Definition Rsth : Equivalence (@eq R) := eq_equivalence.
Definition Reqe : ring_eq_ext Rplus Rmult Ropp (@eq R) := Eq_ext _ _ _.
Definition Rarth : almost_ring_theory 0 1 Rplus Rmult Rminus Ropp (@eq R) := Rth_ARth Rsth Reqe RTheory.

Definition poly := Pol Q.
Definition padd : poly -> poly -> poly := Padd 0%Q qadd Qeq_bool.
Definition pmul : poly -> poly -> poly := Pmul 0%Q 1%Q qadd qmul Qeq_bool.
Definition popp : poly -> poly := Popp Qopp.
Definition peq : poly -> poly -> bool := Peq Qeq_bool.
Definition pvar (k : nat) : poly := mk_X 0%Q 1%Q (Pos.of_succ_nat k).
Definition value_of (xs : list R) : poly -> R := Pphi 0 Rplus Rmult Q2R xs.

Arguments padd : simpl never.
Arguments pmul : simpl never.
Arguments popp : simpl never.
Arguments value_of : simpl never.

Lemma value_add xs p q : value_of xs (padd p q) = value_of xs p + value_of xs q.
Proof. exact (Padd_ok Rsth Reqe Rarth real_morphism q p xs). Qed.
Lemma value_mul xs p q : value_of xs (pmul p q) = value_of xs p * value_of xs q.
Proof. exact (Pmul_ok Rsth Reqe Rarth real_morphism p q xs). Qed.
Lemma value_opp xs p : value_of xs (popp p) = - value_of xs p.
Proof. exact (Popp_ok Rsth Reqe Rarth real_morphism p xs). Qed.
Lemma value_eq xs p q : peq p q = true -> value_of xs p = value_of xs q.
Proof. intro H. exact (Peq_ok Rsth Reqe real_morphism p q H xs). Qed.

Lemma nth_nothing p : BinList.nth 0 p (@nil R) = 0.
Proof.
  assert (forall p, jump p (@nil R) = []) as E by (intro q; induction q; simpl; congruence).
  induction p; simpl; rewrite ?E; auto.
Qed.

Lemma nth_successor p x (xs : list R) : BinList.nth 0 (Pos.succ p) (x :: xs) = BinList.nth 0 p xs.
Proof.
  change (BinList.nth 0 (Pos.succ p) (tl (0 :: x :: xs)) = BinList.nth 0 p (tl (x :: xs))).
  rewrite !nth_jump, jump_succ. simpl jump at 1. now rewrite jump_tl.
Qed.

Lemma nth_positive k (xs : list R) : BinList.nth 0 (Pos.of_succ_nat k) xs = List.nth k xs 0.
Proof.
  revert xs; induction k as [|k IH]; intros [|x xs]; try reflexivity; [apply nth_nothing|].
  simpl Pos.of_succ_nat. now rewrite nth_successor, IH.
Qed.

Lemma value_var xs k : value_of xs (pvar k) = List.nth k xs 0.
Proof.
  rewrite <- nth_positive. symmetry.
  exact (mkX_ok Rsth Reqe Rarth real_morphism (Pos.of_succ_nat k) xs).
Qed.
Lemma value_constant xs c : value_of xs (Pc c) = Q2R c.
Proof. reflexivity. Qed.

(** * Fractions over listed divisors: a polynomial times integer powers of the divisors *)

Definition fraction : Type := poly * list Z.

Fixpoint powers (fs : list R) (e : list Z) : R :=
  match fs, e with f :: fs, n :: e => powerRZ f n * powers fs e | _, _ => 1 end.

Fixpoint plus (e f : list Z) : list Z :=
  match e, f with [], _ => f | _, [] => e | a :: e, b :: f => (a + b)%Z :: plus e f end.
Definition opposite : list Z -> list Z := map Z.opp.
(** What the exponents e exceed f by, and the least of both. *)
Definition excess (e f : list Z) : list Z := map (Z.max 0) (plus e (opposite f)).
Definition least (e f : list Z) : list Z := plus e (opposite (excess e f)).

Fixpoint ppower (p : poly) (n : nat) : poly :=
  match n with O => Pc 1%Q | S O => p | S n => pmul p (ppower p n) end.
Fixpoint lift (fs : list poly) (e : list Z) : poly :=
  match fs, e with
  | f :: fs, n :: e => if (n =? 0)%Z then lift fs e else pmul (ppower f (Z.to_nat n)) (lift fs e)
  | _, _ => Pc 1%Q
  end.

Definition regular (fs : list R) : Prop := Forall (fun f => f <> 0) fs.

Lemma powers_plus fs e f : regular fs -> powers fs (plus e f) = powers fs e * powers fs f.
Proof.
  intro H. revert e f. induction H as [|x l Hx _ IH]; intros [|a e] [|b f]; simpl; try ring.
  rewrite powerRZ_add, IH by assumption. ring.
Qed.

Lemma powers_nonzero fs e : regular fs -> powers fs e <> 0.
Proof.
  intro H. revert e. induction H as [|x l Hx _ IH]; intros [|a e]; simpl; try lra.
  apply Rmult_integral_contrapositive_currified; [now apply powerRZ_NOR|apply IH].
Qed.

Lemma powers_opposite fs e : regular fs -> powers fs (opposite e) * powers fs e = 1.
Proof.
  intro H. revert e. induction H as [|x l Hx _ IH]; intros [|a e]; simpl; try ring.
  transitivity (powerRZ x (- a) * powerRZ x a * (powers l (opposite e) * powers l e)); [ring|].
  rewrite IH, <- powerRZ_add, Z.add_opp_diag_l by assumption. simpl; ring.
Qed.

Section Fractions.
Variable xs : list R.
Variable divisors : list poly.
Let fs := map (value_of xs) divisors.
Hypothesis Hfs : regular fs.

Definition meaning (v : fraction) : R := value_of xs (fst v) * powers fs (snd v).

Lemma value_ppower p n : value_of xs (ppower p n) = value_of xs p ^ n.
Proof.
  induction n as [|[|n] IH].
  - exact Q2R_1.
  - simpl; ring.
  - change (ppower p (S (S n))) with (pmul p (ppower p (S n))). rewrite value_mul, IH. reflexivity.
Qed.

Lemma value_lift e : Forall (fun n => (0 <= n)%Z) e -> value_of xs (lift divisors e) = powers fs e.
Proof.
  unfold fs. clear Hfs fs. revert e; induction divisors as [|f l IH]; intros [|n e] H;
    try exact Q2R_1.
  inversion_clear H. cbn [lift map powers]. destruct (Z.eqb_spec n 0) as [->|].
  - rewrite IH by assumption. simpl. ring.
  - rewrite value_mul, value_ppower, IH by assumption. f_equal.
    rewrite <- (Z2Nat.id n) at 2 by assumption. apply pow_powerRZ.
Qed.

Lemma excess_natural e f : Forall (fun n => (0 <= n)%Z) (excess e f).
Proof. apply Forall_map, Forall_forall. intros. lia. Qed.

Lemma least_comm e f : least e f = least f e.
Proof.
  unfold least, excess, opposite.
  revert f; induction e as [|a e IH]; intros [|b f]; cbn; try reflexivity; f_equal; try lia; [| |apply IH].
  - clear. induction f as [|a f IH]; cbn; f_equal; [lia|apply IH].
  - clear. induction e as [|a e IH]; cbn; f_equal; [lia|apply IH].
Qed.

Lemma powers_excess e f : powers fs (excess e f) * powers fs (least e f) = powers fs e.
Proof.
  unfold least. rewrite powers_plus by assumption.
  replace (powers fs (excess e f) * (powers fs e * powers fs (opposite (excess e f))))
    with (powers fs e * (powers fs (opposite (excess e f)) * powers fs (excess e f))) by ring.
  rewrite powers_opposite by assumption. ring.
Qed.

Definition fconstant (c : Q) : fraction := (Pc c, []).
Definition fopp (v : fraction) : fraction := (popp (fst v), snd v).
Definition fadd (v w : fraction) : fraction :=
  if peq (fst v) (Pc 0%Q) then w else if peq (fst w) (Pc 0%Q) then v else
  (padd (pmul (fst v) (lift divisors (excess (snd v) (snd w)))) (pmul (fst w) (lift divisors (excess (snd w) (snd v)))),
   least (snd v) (snd w)).
Definition fmul (v w : fraction) : fraction := (pmul (fst v) (fst w), plus (snd v) (snd w)).
Fixpoint fpow (v : fraction) (n : nat) : fraction :=
  match n with O => fconstant 1 | S O => v | S n => fmul v (fpow v n) end.
Definition fdiv (v w : fraction) (c : Q) (h : list Z) : option fraction :=
  if peq (fst w) (pmul (Pc c) (lift divisors h)) && negb (Qeq_bool c 0) && forallb (Z.leb 0) h
  then Some (pmul (fst v) (Pc (Qred (/ c))), plus (snd v) (opposite (plus h (snd w))))
  else None.

Lemma meaning_constant c : meaning (fconstant c) = Q2R c.
Proof. change (Q2R c * powers fs [] = Q2R c). destruct fs; simpl; ring. Qed.
Lemma meaning_zero v : peq (fst v) (Pc 0%Q) = true -> meaning v = 0.
Proof.
  intro H. unfold meaning. rewrite (value_eq xs _ _ H), value_constant, Q2R_0. ring.
Qed.
Lemma meaning_opp v : meaning (fopp v) = - meaning v.
Proof. unfold meaning, fopp; simpl. rewrite value_opp. ring. Qed.
Lemma meaning_add v w : meaning (fadd v w) = meaning v + meaning w.
Proof.
  unfold fadd. destruct (peq (fst v) _) eqn:Hv; [rewrite (meaning_zero v) by assumption; ring|].
  destruct (peq (fst w) _) eqn:Hw; [rewrite (meaning_zero w) by assumption; ring|].
  unfold meaning; simpl. rewrite value_add, !value_mul, !value_lift by apply excess_natural.
  rewrite Rmult_plus_distr_r, !Rmult_assoc. rewrite powers_excess.
  now rewrite (least_comm (snd v)), powers_excess.
Qed.
Lemma meaning_mul v w : meaning (fmul v w) = meaning v * meaning w.
Proof. unfold meaning, fmul; simpl. rewrite value_mul, powers_plus by assumption. ring. Qed.
Lemma meaning_pow v n : meaning (fpow v n) = meaning v ^ n.
Proof.
  induction n as [|[|n] IH].
  - simpl. rewrite meaning_constant. exact Q2R_1.
  - simpl; ring.
  - change (fpow v (S (S n))) with (fmul v (fpow v (S n))). rewrite meaning_mul, IH. reflexivity.
Qed.
Lemma Q2R_nonzero c : Qeq_bool c 0 = false -> Q2R c <> 0.
Proof.
  intros H E. apply Qeq_bool_neq in H. apply H, eqR_Qeq. now rewrite E, Q2R_0.
Qed.
Lemma meaning_div v w c h u : fdiv v w c h = Some u -> meaning w <> 0 /\ meaning u = meaning v / meaning w.
Proof.
  unfold fdiv. destruct (_ && _)%bool eqn:H; [|discriminate]. intro E; injection E as <-.
  apply andb_prop in H as [H Hh]. apply andb_prop in H as [H Hc]. apply Bool.negb_true_iff in Hc.
  assert (Forall (fun n => (0 <= n)%Z) h) as N.
  { apply Forall_forall. intros n Hn. rewrite forallb_forall in Hh. now apply Z.leb_le, Hh. }
  unfold meaning; cbn [fst snd]. rewrite (value_eq xs _ _ H), !value_mul, !value_constant, value_lift by assumption.
  rewrite powers_plus, (Qeq_eqR _ _ (Qred_correct _)), Q2R_inv by (assumption || now apply Qeq_bool_neq).
  assert (powers fs (opposite (plus h (snd w))) = / (powers fs h * powers fs (snd w))) as ->.
  { rewrite <- powers_plus by assumption. apply Rmult_eq_reg_r with (powers fs (plus h (snd w))); [|now apply powers_nonzero].
    rewrite powers_opposite by assumption. symmetry. now apply Rinv_l, powers_nonzero. }
  assert (powers fs h <> 0) by now apply powers_nonzero. assert (powers fs (snd w) <> 0) by now apply powers_nonzero.
  assert (Q2R c <> 0) by now apply Q2R_nonzero.
  split; [|now field]. now do 2 (apply Rmult_integral_contrapositive_currified; [|assumption]).
Qed.

(** * The normal form of a formula *)

Fixpoint normal (values : list fraction) (e : expr) : option fraction :=
  let both a b f :=
    match normal values a, normal values b with Some v, Some w => f v w | _, _ => None end in
  match e with
  | Int n => Some (fconstant (inject_Z n))
  | Var k => nth_error values k
  | Opp a => option_map fopp (normal values a)
  | Add a b => both a b (fun v w => Some (fadd v w))
  | Sub a b => both a b (fun v w => Some (fadd v (fopp w)))
  | Mul a b => both a b (fun v w => Some (fmul v w))
  | Div a b c h => both a b (fun v w => fdiv v w c h)
  | Pow a n => option_map (fun v => fpow v n) (normal values a)
  | _ => None
  end.

Definition faithful : list R -> list fraction -> Prop := stands fraction meaning.

Lemma normal_sound env values : faithful env values ->
  forall e v, normal values e = Some v -> eval env e = meaning v.
Proof.
  intro F. induction e as [n|k|a IH|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa b IHb c h|a IH n|a IH|a IH|a IHa b IHb]; simpl; intros u H; try discriminate H;
    try (destruct (normal values a) as [v|]; [|discriminate]; rewrite (IH v) by reflexivity; injection H as <-);
    try (destruct (normal values a) as [v|]; [|discriminate]; destruct (normal values b) as [w|]; [|discriminate];
         rewrite (IHa v), (IHb w) by reflexivity; try injection H as <-).
  - injection H as <-. rewrite meaning_constant. unfold Q2R; simpl. lra.
  - now apply F.
  - now rewrite meaning_opp.
  - now rewrite meaning_add.
  - now rewrite meaning_add, meaning_opp.
  - now rewrite meaning_mul.
  - symmetry. now apply (meaning_div v w c h).
  - now rewrite meaning_pow.
Qed.

(** * What follows from constraints *)

Definition above (v : fraction) : fraction := (fst v, map (Z.max 0) (snd v)).

Lemma meaning_above v : meaning v = 0 -> meaning (above v) = 0.
Proof.
  unfold meaning, above; simpl. intro H.
  destruct (Rmult_integral _ _ H) as [->|E]; [ring|now destruct (powers_nonzero fs (snd v) Hfs)].
Qed.

(** The difference of the sides to a power, times divisors, is a combination of the constraints. *)
Inductive goal : Type := Equation (a b : expr) (power : nat) (multiplier : list Z) (cofactors : list expr).

Fixpoint combination (values : list fraction) (cofactors : list expr) (constraints : list fraction) : option fraction :=
  match cofactors, constraints with
  | [], _ => Some (fconstant 0)
  | c :: cs, g :: gs =>
      match normal values c, combination values cs gs with
      | Some v, Some w => Some (fadd (fmul v (above g)) w)
      | _, _ => None
      end
  | _, _ => None
  end.

Definition reached (values constraints : list fraction) (g : goal) : bool :=
  let '(Equation a b power multiplier cofactors) := g in
  match normal values (Sub a b), combination values cofactors constraints with
  | Some v, Some w => 
      let d := fpow v power in
      peq (fst (fadd (fst d, plus (snd d) multiplier) (fopp w))) (Pc 0%Q)
  | _, _ => false
  end.

Definition concludes (env : list R) (g : goal) : Prop := let '(Equation a b _ _ _) := g in eval env a = eval env b.

Lemma combination_zero env values constraints : faithful env values -> Forall (fun v => meaning v = 0) constraints ->
  forall cofactors w, combination values cofactors constraints = Some w -> meaning w = 0.
Proof.
  intros F Z. induction Z as [|g gs Hg _ IH]; intros [|c cs] w; simpl; intro H; try discriminate;
    try (injection H as <-; rewrite meaning_constant; exact Q2R_0).
  destruct (normal values c) as [v|]; [|discriminate].
  destruct (combination values cs gs) as [u|] eqn:E; [|discriminate]. injection H as <-.
  rewrite meaning_add, meaning_mul, meaning_above, (IH cs u) by assumption. ring.
Qed.

Lemma reached_sound env values constraints g : faithful env values -> Forall (fun v => meaning v = 0) constraints ->
  reached values constraints g = true -> concludes env g.
Proof.
  destruct g as [a b power multiplier cofactors]. unfold reached, concludes. intros F Z H.
  destruct (normal values (Sub a b)) as [v|] eqn:N; [|discriminate].
  destruct (combination values cofactors constraints) as [w|] eqn:C; [|discriminate].
  apply meaning_zero in H. rewrite meaning_add, meaning_opp, (combination_zero env values constraints F Z _ _ C) in H.
  apply (normal_sound env values F) in N. simpl in N. apply Rminus_diag_uniq. rewrite N.
  destruct (Req_dec (meaning v) 0) as [|D]; [assumption|exfalso].
  apply (pow_nonzero _ power) in D. rewrite <- meaning_pow in D. unfold meaning in D, H. simpl in H.
  rewrite powers_plus in H by assumption.
  assert (value_of xs (fst (fpow v power)) * powers fs (snd (fpow v power)) * powers fs multiplier = 0) as E by lra.
  apply Rmult_integral in E as [E|E]; [now apply D|now apply powers_nonzero in E].
Qed.

End Fractions.

Lemma traverse_Forall {A B} (f : A -> option B) (P : A -> Prop) (Q : B -> Prop) l bs :
  (forall a b, f a = Some b -> P a -> Q b) -> traverse f l = Some bs -> Forall P l -> Forall Q bs.
Proof.
  intros H. revert bs. induction l as [|a l IH]; simpl; intros bs E F; [injection E as <-; constructor|].
  destruct (f a) eqn:Ea; [|discriminate]. destruct (traverse f l); [|discriminate]. injection E as <-.
  inversion_clear F. constructor; eauto.
Qed.

Definition base (n : nat) : list fraction := map (fun k => (pvar k, [])) (seq 0 n).
Definition polynomial (v : option fraction) : option poly :=
  match v with Some (p, []) => Some p | _ => None end.

Lemma base_faithful (divisors : list poly) xs ss : faithful xs divisors (xs ++ ss) (base (length xs)).
Proof.
  intros k v H. unfold base in H. rewrite nth_error_map in H.
  destruct (nth_error (seq 0 (length xs)) k) as [j|] eqn:E; [|discriminate]. injection H as <-.
  assert (k < length xs)%nat as L.
  { rewrite <- (seq_length (length xs) 0). apply nth_error_Some. now rewrite E. }
  assert (j = k) as -> by (apply (nth_error_nth _ _ O) in E; now rewrite seq_nth in E by assumption).
  unfold meaning; cbn [fst snd]. rewrite value_var, app_nth1 by assumption. destruct (map _ divisors); simpl; ring.
Qed.

(** The polynomials that formulas without division are. *)
Definition polynomials (n : nat) : list expr -> option (list poly) := traverse (fun e => polynomial (normal [] (base n) e)).

Lemma polynomials_regular xs es ps : polynomials (length xs) es = Some ps ->
  Forall (fun e => eval xs e <> 0) es -> regular (map (value_of xs) ps).
Proof.
  intros E H. apply Forall_map. refine (traverse_Forall _ _ _ _ _ _ E H). clear. intros e p E N.
  destruct (normal [] (base (length xs)) e) as [[q [|]]|] eqn:Ne; try discriminate. injection E as ->.
  assert (regular (map (value_of xs) [])) as R0 by constructor.
  rewrite <- (app_nil_r xs) in N at 1.
  rewrite (normal_sound xs [] R0 _ _ (base_faithful [] xs []) _ _ Ne) in N.
  unfold meaning in N. cbn [fst snd powers map] in N. lra.
Qed.

(** Whether the goals follow from divisors and units that are not zero, definitions, and constraints that are zero;
    the first [n] variables are free, [m] are defined, and the goals have more that they share. *)
Definition decided (n m : nat) (divisors definitions units constraints shared : list expr) (goals : list goal) : bool :=
  match polynomials n divisors with
  | None => false
  | Some ps =>
  match extended (normal ps) (base n) definitions with
  | None => false
  | Some values =>
  match traverse (normal ps values) units with
  | None => false
  | Some us =>
  let qs := (ps ++ map fst us)%list in
  match extended (normal qs) (base n) definitions with
  | None => false
  | Some values =>
  match traverse (normal qs values) constraints with
  | None => false
  | Some cs =>
  match extended (normal qs) values shared with
  | None => false
  | Some values => Nat.eqb m (length definitions) && forallb (reached qs values cs) goals
  end end end end end end.

Theorem follows xs ss divisors definitions units constraints shared goals :
  decided (length xs) (length ss) divisors definitions units constraints shared goals = true ->
  all (map (fun d => eval xs d <> 0) divisors) ->
  all (defined (xs ++ ss) (length xs) definitions) ->
  all (map (fun u => eval (xs ++ ss) u <> 0) units) ->
  all (map (fun c => eval (xs ++ ss) c = 0) constraints) ->
  all (map (concludes (run (xs ++ ss) shared)) goals).
Proof.
  unfold decided. rewrite !all_map. intros H Hd Hdef Hu Hc.
  destruct (polynomials _ divisors) as [ps|] eqn:Ed; [|discriminate].
  destruct (extended (normal ps) _ definitions) as [values|] eqn:Ev; [|discriminate].
  destruct (traverse (normal ps values) units) as [us|] eqn:Eu; [|discriminate].
  destruct (extended (normal (ps ++ map fst us)) _ definitions) as [values'|] eqn:Ev'; [|discriminate].
  destruct (traverse (normal _ values') constraints) as [cs|] eqn:Ec; [|discriminate].
  destruct (extended (normal _) values' shared) as [more|] eqn:Es; [|discriminate].
  apply andb_prop in H as [Lm H]. apply Nat.eqb_eq in Lm.
  assert (length (base (length xs)) = length xs) as L by (unfold base; now rewrite map_length, seq_length).
  pose proof (polynomials_regular xs divisors ps Ed Hd) as Rps.
  assert (faithful xs ps (xs ++ ss) values) as F.
  { apply (defined_stands _ _ _ (normal_sound xs ps Rps) (xs ++ ss) definitions (base (length xs))); [apply base_faithful|assumption|].
    now rewrite L. }
  set (qs := (ps ++ map fst us)%list) in *.
  assert (regular (map (value_of xs) qs)) as Rqs.
  { unfold qs. rewrite map_app. apply Forall_app. split; [assumption|].
    rewrite map_map. apply Forall_map. refine (traverse_Forall _ _ _ _ _ _ Eu Hu). intros u v E N Z.
    apply N. rewrite (normal_sound xs ps Rps _ _ F _ _ E). unfold meaning. rewrite Z. ring. }
  assert (faithful xs qs (xs ++ ss) values') as F'.
  { apply (defined_stands _ _ _ (normal_sound xs qs Rqs) (xs ++ ss) definitions (base (length xs))); [apply base_faithful|assumption|].
    now rewrite L. }
  assert (faithful xs qs (run (xs ++ ss) shared) more) as Fs.
  { apply (run_stands _ _ _ (normal_sound xs qs Rqs) _ shared values'); [|assumption|assumption].
    now rewrite (extended_length _ _ _ _ _ Ev'), L, app_length, Lm. }
  apply Forall_forall. intros g Hg. rewrite forallb_forall in H.
  apply (reached_sound xs qs Rqs _ _ cs g Fs); [|now apply H].
  refine (traverse_Forall _ _ _ _ _ _ Ec Hc). intros c v E Zc.
  now rewrite <- (normal_sound xs qs Rqs _ _ F' _ _ E).
Qed.

(** * Formulas at rational points *)

Fixpoint qpow (q : Q) (n : nat) : Q := match n with O => 1%Q | S n => qmul q (qpow q n) end.

Fixpoint number (env : list Q) (e : expr) : option Q :=
  let both a b f := match number env a, number env b with Some p, Some q => f p q | _, _ => None end in
  match e with
  | Int n => Some (inject_Z n)
  | Var k => nth_error env k
  | Opp a => option_map Qopp (number env a)
  | Add a b => both a b (fun p q => Some (qadd p q))
  | Sub a b => both a b (fun p q => Some (qsub p q))
  | Mul a b => both a b (fun p q => Some (p * q)%Q)
  | Div a b _ _ => both a b (fun p q => if Qeq_bool q 0 then None else Some (p / q)%Q)
  | Pow a n => option_map (fun p => qpow p n) (number env a)
  | Abs a => option_map Qabs (number env a)
  | Floor a => option_map (fun p => inject_Z (Qfloor p)) (number env a)
  | Compare a b => both a b (fun p q => Some (if Qle_bool p q then 1%Q else 0%Q))
  end.

Definition holds (env : list Q) (l : literal) : bool :=
  let compare a b f := match number env a, number env b with Some p, Some q => f p q | _, _ => false end in
  match l with
  | Zero a => compare a (Int 0) Qeq_bool
  | Nonzero a => compare a (Int 0) (fun p q => negb (Qeq_bool p q))
  | Equal a b => compare a b Qeq_bool
  | Unequal a b => compare a b (fun p q => negb (Qeq_bool p q))
  | Less a b => compare a b (fun p q => negb (Qle_bool q p))
  | AtMost a b => compare a b Qle_bool
  | Regular rows =>
      match traverse (traverse (number env)) rows with Some m => invertible m | None => false end
  end.

Definition evaluated (xs : list Q) (definitions : list expr) (literals : list literal) : bool :=
  match extended number xs definitions with Some env => forallb (holds env) literals | None => false end.

Definition rational : list R -> list Q -> Prop := stands Q Q2R.

Lemma Q2R_Z n : Q2R (inject_Z n) = IZR n.
Proof. unfold Q2R, inject_Z; simpl; lra. Qed.
Lemma Q2R_power q n : Q2R (qpow q n) = Q2R q ^ n.
Proof. induction n as [|n IH]; simpl; [exact Q2R_1|]. unfold qmul. now rewrite Q2R_red, Q2R_mult, IH. Qed.

Lemma Q2R_floor q : floor (Q2R q) = Q2R (inject_Z (Qfloor q)).
Proof.
  rewrite Q2R_Z. unfold floor. f_equal. destruct (base_Int_part (Q2R q)) as [L1 U1].
  pose proof (Qle_Rle _ _ (Qfloor_le q)) as L. pose proof (Qlt_Rlt _ _ (Qlt_floor q)) as U.
  rewrite Q2R_Z in L, U. rewrite plus_IZR in U.
  apply Z.le_antisymm; apply Z.lt_succ_r, lt_IZR; rewrite succ_IZR; lra.
Qed.
Lemma Q2R_absolute q : Rabs (Q2R q) = Q2R (Qabs q).
Proof.
  destruct (Qlt_le_dec q 0) as [N|P].
  - rewrite Qabs_neg by now apply Qlt_le_weak. apply Qlt_Rlt in N. rewrite Q2R_0 in N.
    rewrite Q2R_opp. now apply Rabs_left.
  - rewrite Qabs_pos by assumption. apply Qle_Rle in P. rewrite Q2R_0 in P. apply Rabs_right. lra.
Qed.
Lemma Q2R_compared p q : at_most (Q2R p) (Q2R q) = Q2R (if Qle_bool p q then 1 else 0).
Proof.
  unfold at_most. destruct (Rle_dec (Q2R p) (Q2R q)) as [L|L]; destruct (Qle_bool p q) eqn:E;
    rewrite ?Q2R_1, ?Q2R_0; try reflexivity.
  - apply Rle_Qle, Qle_bool_iff in L. congruence.
  - apply Qle_bool_iff, Qle_Rle in E. contradiction.
Qed.

Lemma number_sound env values : rational env values -> forall e q, number values e = Some q -> eval env e = Q2R q.
Proof.
  intro F. induction e as [n|k|a IH|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa b IHb c h|a IH n|a IH|a IH|a IHa b IHb]; simpl; intros u H;
    try (destruct (number values a) as [p|]; [|discriminate]; rewrite (IH p) by reflexivity; injection H as <-);
    try (destruct (number values a) as [p|]; [|discriminate]; destruct (number values b) as [q|]; [|discriminate];
         rewrite (IHa p), (IHb q) by reflexivity; try injection H as <-);
    unfold qadd, qsub; rewrite ?Q2R_red.
  - injection H as <-. now rewrite Q2R_Z.
  - now apply F.
  - now rewrite Q2R_opp.
  - now rewrite Q2R_plus.
  - now rewrite Q2R_minus.
  - now rewrite Q2R_mult.
  - destruct (Qeq_bool q 0) eqn:E; [discriminate|]. injection H as <-.
    rewrite Q2R_div; [reflexivity|now apply Qeq_bool_neq].
  - now rewrite Q2R_power.
  - apply Q2R_absolute.
  - apply Q2R_floor.
  - apply Q2R_compared.
Qed.

Lemma traverse_map {A} (f : A -> option Q) (g : A -> R) : (forall a q, f a = Some q -> g a = Q2R q) ->
  forall l qs, traverse f l = Some qs -> map g l = map Q2R qs.
Proof.
  intros H. induction l as [|a l IH]; simpl; intros qs E; [now injection E as <-|].
  destruct (f a) eqn:Ea; [|discriminate]. destruct (traverse f l); [|discriminate]. injection E as <-.
  simpl. f_equal; auto.
Qed.

Lemma traverse_matrix env values rows m : rational env values -> traverse (traverse (number values)) rows = Some m ->
  map (map (eval env)) rows = map (map Q2R) m.
Proof.
  intro F. revert m. induction rows as [|row rows IH]; simpl; intros m E; [now injection E as <-|].
  destruct (traverse (number values) row) as [r|] eqn:Er; [|discriminate].
  destruct (traverse _ rows) as [rs|]; [|discriminate]. injection E as <-.
  simpl. f_equal; [|now apply IH].
  apply (traverse_map (number values)); [|assumption]. intros a q. now apply number_sound.
Qed.

Lemma holds_sound env values : rational env values -> forall l, holds values l = true -> says env l.
Proof.
  intros F l. pose proof (number_sound env values F) as S.
  assert (forall a b f, match number values a, number values b with Some p, Some q => f p q | _, _ => false end = true ->
    exists p q, eval env a = Q2R p /\ eval env b = Q2R q /\ f p q = true) as C.
  { intros a b f H. destruct (number values a) as [p|] eqn:Ea; [|discriminate].
    destruct (number values b) as [q|] eqn:Eb; [|discriminate]. exists p, q. auto. }
  destruct l as [a|a|a b|a b|a b|a b|rows]; unfold holds, says; intro H.
  - apply C in H as (p & q & -> & E & H). simpl in E. rewrite E. now apply Qeq_eqR, Qeq_bool_iff.
  - apply C in H as (p & q & -> & E & H). simpl in E. rewrite E. intro D. apply Bool.negb_true_iff, Qeq_bool_neq in H.
    now apply H, eqR_Qeq.
  - apply C in H as (p & q & -> & -> & H). now apply Qeq_eqR, Qeq_bool_iff.
  - apply C in H as (p & q & -> & -> & H). intro D. apply Bool.negb_true_iff, Qeq_bool_neq in H. now apply H, eqR_Qeq.
  - apply C in H as (p & q & -> & -> & H). apply Bool.negb_true_iff in H.
    apply Rnot_le_lt. intro D. apply Rle_Qle, Qle_bool_iff in D. congruence.
  - apply C in H as (p & q & -> & -> & H). now apply Qle_Rle, Qle_bool_iff.
  - destruct (traverse _ rows) as [m|] eqn:E; [|discriminate].
    rewrite (traverse_matrix _ _ _ _ F E). now apply invertible_regular.
Qed.

Theorem computed xs ss definitions literals :
  evaluated xs definitions literals = true ->
  all (defined (map Q2R xs ++ ss) (length xs) definitions) ->
  all (map (says (map Q2R xs ++ ss)) literals).
Proof.
  unfold evaluated. intros H D. rewrite all_map.
  destruct (extended number xs definitions) as [values|] eqn:E; [|discriminate].
  apply Forall_forall. intros l Hl. rewrite forallb_forall in H.
  apply holds_sound with values; [|now apply H].
  refine (defined_stands _ _ _ number_sound _ _ _ _ _ E D).
  intros k q N. rewrite app_nth1; [|rewrite map_length; apply nth_error_Some; now rewrite N].
  apply (map_nth_error Q2R) in N. now apply nth_error_nth.
Qed.

(** The same without variables, of terms that a proof shares. *)
Theorem calculated shared literals :
  evaluated [] shared literals = true -> all (map (says (run [] shared)) literals).
Proof.
  unfold evaluated. intro H. rewrite all_map. destruct (extended number [] shared) as [values|] eqn:E; [|discriminate].
  apply Forall_forall. intros l Hl. rewrite forallb_forall in H. apply holds_sound with values; [|now apply H].
  refine (run_stands _ _ _ number_sound [] _ [] _ eq_refl _ E). intros [|k] q N; discriminate.
Qed.

(** * Proportional lists *)

Lemma proportional p d (pairs : list (R * R)) : p <> 0 -> d <> 0 ->
  all (map (fun q => fst q * d = snd q * p) pairs) ->
  exists k, all ((k <> 0) :: map (fun q => fst q = k * snd q) pairs).
Proof.
  intros P D H. exists (p / d). rewrite all_cons. split.
  - apply Rmult_integral_contrapositive_currified; [assumption|now apply Rinv_neq_0_compat].
  - rewrite all_map in *. apply Forall_forall. intros q I. rewrite Forall_forall in H. specialize (H q I).
    apply Rmult_eq_reg_r with d; [|assumption]. rewrite H. field. assumption.
Qed.

(** * Limits *)

Fixpoint entire (e : expr) : bool :=
  match e with
  | Int _ | Var _ => true
  | Opp a | Pow a _ => entire a
  | Add a b | Sub a b | Mul a b => entire a && entire b
  | _ => false
  end.

Lemma same_continuous (f g : R -> R) t : (forall u, f u = g u) -> continuity_pt f t -> continuity_pt g t.
Proof. intros E C e He. destruct (C e He) as (a & Ha & H). exists a. split; auto. intros u Hu. rewrite <- !E; auto. Qed.

Lemma entire_continuous xs e t : entire e = true -> continuity_pt (fun t => eval (xs ++ [t]) e) t.
Proof.
  induction e as [n|k|a IH|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa b IHb c h|a IH n|a IH|a IH|a IHa b IHb]; simpl; intro H;
    try discriminate; try (apply andb_prop in H as [H1 H2]).
  - apply continuity_pt_const. now intros ? ?.
  - destruct (Nat.lt_trichotomy k (length xs)) as [L|[->|L]].
    + apply (same_continuous (fun _ => List.nth k xs 0)); [|apply continuity_pt_const; now intros ? ?].
      intro u. now rewrite app_nth1.
    + apply (same_continuous id); [|apply derivable_continuous_pt, derivable_pt_id].
      intro u. now rewrite app_nth2, Nat.sub_diag by lia.
    + apply (same_continuous (fun _ => 0)); [|apply continuity_pt_const; now intros ? ?].
      intro u. symmetry. apply List.nth_overflow. rewrite app_length. simpl. lia.
  - now apply continuity_pt_opp, IH.
  - apply continuity_pt_plus; auto.
  - apply continuity_pt_minus; auto.
  - apply continuity_pt_mult; auto.
  - induction n as [|n IHn]; simpl; [apply continuity_pt_const; now intros ? ?|].
    apply continuity_pt_mult; [now apply IH|exact IHn].
Qed.

(** A quotient n/d of polynomials is the limit of f at 0, where f d = n. *)
Lemma limit_of_quotient (xs : list R) (n d : expr) (f : R -> R) (domain : R -> Prop) (l : R) :
  entire n && entire d = true -> (forall t, domain t -> t <> 0) ->
  (forall t, domain t -> f t * eval (xs ++ [t]) d = eval (xs ++ [t]) n) ->
  eval (xs ++ [0]) n = l * eval (xs ++ [0]) d /\ 1 / eval (xs ++ [0]) d * eval (xs ++ [0]) d = 1 ->
  limit1_in f domain l 0.
Proof.
  intros E Z F [L D]. apply andb_prop in E as [En Ed].
  assert (eval (xs ++ [0]) d <> 0) as D0 by (intro C; rewrite C, Rmult_0_r in D; lra).
  pose proof (entire_continuous xs d 0 Ed) as Cd.
  assert (continuity_pt (fun t => eval (xs ++ [t]) n / eval (xs ++ [t]) d) 0) as Cq.
  { apply continuity_pt_div; [now apply entire_continuous|assumption|assumption]. }
  destruct (continuous_neq_0 _ 0 Cd D0) as [eps Heps].
  intros e He. destruct (Cq e He) as (a & Ha & H). exists (Rmin a eps). split.
  { apply Rmin_Rgt_r. split; [assumption|apply cond_pos]. }
  assert (forall t : R, domain t -> Rabs (t - 0) < Rmin a eps -> Rabs (f t - l) < e) as G.
  { intros t Dt Nt.
    assert (Rabs (t - 0) < eps) as N1 by (eapply Rlt_le_trans; [exact Nt|apply Rmin_r]).
    assert (Rabs (t - 0) < a) as N2 by (eapply Rlt_le_trans; [exact Nt|apply Rmin_l]).
    rewrite Rminus_0_r in N1. specialize (Heps t N1). rewrite Rplus_0_l in Heps.
    replace (f t) with (eval (xs ++ [t]) n / eval (xs ++ [t]) d) by (rewrite <- (F t Dt); field; assumption).
    replace l with (eval (xs ++ [0]) n / eval (xs ++ [0]) d) by (rewrite L; field; assumption).
    apply (H t). split; [|exact N2]. split; [exact I|]. intro C. now apply (Z t). }
  intros t [Dt Nt]. exact (G t Dt Nt).
Qed.

(** * Derivatives of several functions of several variables *)

(** The point x after the time t, when it moves with the velocity v. *)
Definition moved (x v : list R) (t : R) : list R := map (fun p => fst p + t * snd p) (combine x v).
(** The i-th component of F, along v, has the derivative d at x. *)
Definition slope (F : list R -> list R) (x v : list R) (i : nat) (d : R) : Prop :=
  derivable_pt_lim (fun t => List.nth i (F (moved x v t)) 0) 0 d.
(** No component of F has a derivative other than zero along v at x: v is in the kernel of the Jacobian matrix. *)
Definition stationary (F : list R -> list R) (x v : list R) : Prop := forall i, slope F x v i 0.
(** The derivatives of F at x by some variables, a list for each of them, are a matrix with an inverse. *)
Definition regular_derivatives (F : list R -> list R) (x : list R) (variables : list nat) : Prop :=
  exists m, Forall2 (fun k column => forall i, slope F x (basis (length x) k) i (List.nth i column 0)) variables m /\
    regular_matrix m.

(** A program: definitions, and results. *)
Definition program (definitions results : list expr) (x : list R) : list R := map (eval (run x definitions)) results.

Definition coordinates (n : nat) (x : list R) : list R := map (fun k => List.nth k x 0) (seq 0 n).

Lemma coordinates_all x : coordinates (length x) x = x.
Proof. apply nth_all. Qed.

Lemma is_program F definitions results n :
  (forall x, F (coordinates n x) = program definitions results (coordinates n x)) ->
  forall x, length x = n -> F x = program definitions results x.
Proof. intros H x <-. now rewrite <- (coordinates_all x). Qed.

(** Pairs of a value and a derivative, over any numbers that mean real ones. *)
Section Dual.
Variable A : Type.
Variable real : A -> R.
Variables (constant : Q -> A) (plus_of times_of : A -> A -> A) (minus_of : A -> A).
Variable quotient_of : A -> A -> Q -> list Z -> option A.
Hypothesis real_constant : forall c, real (constant c) = Q2R c.
Hypothesis real_plus : forall a b, real (plus_of a b) = real a + real b.
Hypothesis real_times : forall a b, real (times_of a b) = real a * real b.
Hypothesis real_minus : forall a, real (minus_of a) = - real a.
Hypothesis real_quotient : forall a b c h q, quotient_of a b c h = Some q -> real b <> 0 /\ real q = real a / real b.

Definition dual : Type := A * A.
Definition dconstant (c : Q) : dual := (constant c, constant 0).
Definition dplus (u v : dual) : dual := (plus_of (fst u) (fst v), plus_of (snd u) (snd v)).
Definition dminus (u : dual) : dual := (minus_of (fst u), minus_of (snd u)).
Definition dtimes (u v : dual) : dual :=
  (times_of (fst u) (fst v), plus_of (times_of (snd u) (fst v)) (times_of (fst u) (snd v))).
Definition dquotient (u v : dual) (c : Q) (h : list Z) : option dual :=
  match quotient_of (fst u) (fst v) c h with
  | Some q =>
      match quotient_of (plus_of (snd u) (minus_of (times_of q (snd v)))) (fst v) c h with
      | Some d => Some (q, d)
      | None => None
      end
  | None => None
  end.
Fixpoint dpower (u : dual) (n : nat) : dual :=
  match n with O => dconstant 1 | S O => u | S n => dtimes u (dpower u n) end.

Fixpoint differentiated (values : list dual) (e : expr) : option dual :=
  let both a b f :=
    match differentiated values a, differentiated values b with Some u, Some v => f u v | _, _ => None end in
  match e with
  | Int n => Some (dconstant (inject_Z n))
  | Var k => nth_error values k
  | Opp a => option_map dminus (differentiated values a)
  | Add a b => both a b (fun u v => Some (dplus u v))
  | Sub a b => both a b (fun u v => Some (dplus u (dminus v)))
  | Mul a b => both a b (fun u v => Some (dtimes u v))
  | Div a b c h => both a b (fun u v => dquotient u v c h)
  | Pow a n => option_map (fun u => dpower u n) (differentiated values a)
  | _ => None
  end.

(** A function has at 0 the value and the derivative of a pair. *)
Definition has (f : R -> R) (u : dual) : Prop := f 0 = real (fst u) /\ derivable_pt_lim f 0 (real (snd u)).

Lemma has_constant c r : r = Q2R c -> has (fun _ => r) (dconstant c).
Proof.
  intro E. split; cbn [dconstant fst snd]; rewrite real_constant; [exact E|].
  rewrite Q2R_0. apply derivable_pt_lim_const.
Qed.
Lemma has_plus f g u v : has f u -> has g v -> has (fun t => f t + g t) (dplus u v).
Proof.
  intros [E1 D1] [E2 D2]. split; cbn [dplus fst snd]; rewrite real_plus; [now rewrite E1, E2|].
  now apply (derivable_pt_lim_plus f g).
Qed.
Lemma has_minus f u : has f u -> has (fun t => - f t) (dminus u).
Proof.
  intros [E D]. split; cbn [dminus fst snd]; rewrite real_minus; [now rewrite E|]. now apply (derivable_pt_lim_opp f).
Qed.
Lemma has_times f g u v : has f u -> has g v -> has (fun t => f t * g t) (dtimes u v).
Proof.
  intros [E1 D1] [E2 D2]. split; cbn [dtimes fst snd]; rewrite ?real_plus, !real_times; [now rewrite E1, E2|].
  rewrite <- E1, <- E2. now apply (derivable_pt_lim_mult f g).
Qed.
Lemma has_quotient f g u v c h q : has f u -> has g v -> dquotient u v c h = Some q -> has (fun t => f t / g t) q.
Proof.
  intros [E1 D1] [E2 D2] H. unfold dquotient in H.
  destruct (quotient_of (fst u) (fst v) c h) as [a|] eqn:Ha; [|discriminate].
  destruct (quotient_of (plus_of _ _) (fst v) c h) as [d|] eqn:Hd; [|discriminate]. injection H as <-.
  apply real_quotient in Ha as [N Ha]. apply real_quotient in Hd as [_ Hd].
  split; cbn [fst snd]; [now rewrite Ha, E1, E2|].
  rewrite Hd, real_plus, real_minus, real_times, Ha.
  replace ((real (snd u) + - (real (fst u) / real (fst v) * real (snd v))) / real (fst v))
    with ((real (snd u) * g 0 - real (snd v) * f 0) / Rsqr (g 0)) by (rewrite E1, E2; unfold Rsqr; field; exact N).
  apply (derivable_pt_lim_div f g); [assumption|assumption|now rewrite E2].
Qed.
Lemma has_power f u n : has f u -> has (fun t => f t ^ n) (dpower u n).
Proof.
  intro H. induction n as [|[|n] IH].
  - apply has_constant. simpl. symmetry. exact Q2R_1.
  - destruct H as [E D]. split; cbn [dpower]; [simpl; now rewrite Rmult_1_r|].
    apply (derivable_pt_lim_ext f); [intro t; simpl; ring|assumption].
  - exact (has_times f (fun t => f t ^ S n) u _ H IH).
Qed.

Definition tracked : (R -> list R) -> list dual -> Prop := entries_mean R dual has.

Lemma differentiated_sound env values : tracked env values ->
  forall e u, differentiated values e = Some u -> has (fun t => eval (env t) e) u.
Proof.
  intro T. induction e as [n|k|a IH|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa b IHb c h|a IH n|a IH|a IH|a IHa b IHb]; simpl; intros w H; try discriminate H;
    try (destruct (differentiated values a) as [u|]; [|discriminate]; specialize (IH u eq_refl); cbn [option_map] in H; injection H as <-);
    try (destruct (differentiated values a) as [u|]; [|discriminate];
         destruct (differentiated values b) as [v|]; [|discriminate];
         specialize (IHa u eq_refl); specialize (IHb v eq_refl); try injection H as <-).
  - injection H as <-. apply has_constant. unfold Q2R, inject_Z. simpl. lra.
  - now apply T.
  - now apply has_minus.
  - now apply has_plus.
  - apply (has_plus (fun t => eval (env t) a) (fun t => - eval (env t) b)); [assumption|now apply has_minus].
  - now apply has_times.
  - now apply (has_quotient _ _ u v c h).
  - now apply has_power.
Qed.

Lemma has_same f g u : (forall t, f t = g t) -> has f u -> has g u.
Proof. intros E [V D]. split; [now rewrite <- E|now apply (derivable_pt_lim_ext f)]. Qed.

(** The derivatives of the results of a program, if its variables have values and derivatives. *)
Definition derived (values : list dual) (definitions results : list expr) : option (list A) :=
  match extended differentiated values definitions with
  | Some more => option_map (map snd) (traverse (differentiated more) results)
  | None => None
  end.

Lemma nth_moved x v t k : length v = length x ->
  List.nth k (moved x v t) 0 = List.nth k x 0 + t * List.nth k v 0.
Proof.
  unfold moved. revert v k. induction x as [|a x IH]; intros [|b v] [|k] H; try discriminate; simpl; try ring.
  apply IH. simpl in H. lia.
Qed.

Lemma length_moved x v t : length v = length x -> length (moved x v t) = length x.
Proof. intro H. unfold moved. rewrite map_length, combine_length. lia. Qed.

Lemma traverse_nth {B C} (f : B -> option C) l m i c : traverse f l = Some m -> nth_error m i = Some c ->
  exists b, nth_error l i = Some b /\ f b = Some c.
Proof.
  revert m i. induction l as [|b l IH]; simpl; intros m i E H; [injection E as <-; destruct i; discriminate|].
  destruct (f b) eqn:F; [|discriminate]. destruct (traverse f l); [|discriminate]. injection E as <-.
  destruct i as [|i]; simpl in *; [injection H as <-; eauto|eauto].
Qed.

Lemma traverse_length {B C} (f : B -> option C) l m : traverse f l = Some m -> length m = length l.
Proof.
  revert m. induction l as [|b l IH]; simpl; intros m E; [now injection E as <-|].
  destruct (f b); [|discriminate]. destruct (traverse f l); [|discriminate]. injection E as <-. simpl. now rewrite IH.
Qed.

(** The derivatives that were computed are those of the functions that the program is. *)
Lemma derived_sound x v values definitions results slopes F :
  length v = length x -> length values = length x ->
  (forall k u, nth_error values k = Some u -> List.nth k x 0 = real (fst u) /\ List.nth k v 0 = real (snd u)) ->
  (forall t, F (moved x v t) = program definitions results (moved x v t)) ->
  derived values definitions results = Some slopes ->
  forall i, slope F x v i (List.nth i (map real slopes) 0).
Proof.
  intros Lv L V E H i. unfold derived in H.
  destruct (extended differentiated values definitions) as [more|] eqn:R0; [|discriminate].
  destruct (traverse (differentiated more) results) as [pairs|] eqn:P; [|discriminate]. injection H as <-.
  assert (tracked (fun t => run (moved x v t) definitions) more) as T.
  { refine (extended_run R dual differentiated has has_same differentiated_sound definitions (moved x v) values _ _ _ R0).
    - intro t. now rewrite length_moved by assumption.
    - intros k u H. destruct (V k u H) as [V1 V2]. split.
      + rewrite nth_moved by assumption. rewrite V1. ring.
      + rewrite <- V2. apply (derivable_pt_lim_ext (fun t => List.nth k x 0 + t * List.nth k v 0)).
        { intro t. now rewrite nth_moved by assumption. }
        replace (List.nth k v 0) with (0 + (1 * List.nth k v 0 + 0 * 0)) at 1 by ring.
        apply derivable_pt_lim_plus; [apply derivable_pt_lim_const|].
        apply (derivable_pt_lim_mult id (fun _ => List.nth k v 0) 0 1 0);
          [apply derivable_pt_lim_id|apply derivable_pt_lim_const]. }
  unfold slope. apply (derivable_pt_lim_ext (fun t => List.nth i (program definitions results (moved x v t)) 0)).
  { intro t. now rewrite E. }
  destruct (nth_error pairs i) as [u|] eqn:U.
  - destruct (traverse_nth _ _ _ _ _ P U) as (e & Ee & De).
    apply (differentiated_sound _ _ T) in De as [_ D].
    rewrite (nth_error_nth _ _ 0 (map_nth_error real i _ (map_nth_error snd i pairs U))).
    apply (derivable_pt_lim_ext (fun t => eval (run (moved x v t) definitions) e)); [|assumption].
    intro t. unfold program. symmetry. apply nth_error_nth. now rewrite nth_error_map, Ee.
  - apply nth_error_None in U. rewrite List.nth_overflow by (rewrite !map_length; exact U).
    apply (derivable_pt_lim_ext (fun _ => 0)); [|apply derivable_pt_lim_const].
    intro t. unfold program. rewrite List.nth_overflow; [reflexivity|].
    rewrite map_length, <- (traverse_length _ _ _ P). assumption.
Qed.
End Dual.

(** ** Along a direction that is given by formulas *)

Definition still (n : nat) (divisors direction definitions results : list expr) : bool :=
  match polynomials n divisors with
  | None => false
  | Some ps =>
  match traverse (normal ps (base n)) direction with
  | None => false
  | Some v =>
      Nat.eqb (length v) n &&
      match derived fraction fconstant (fadd ps) fmul fopp (fdiv ps) (combine (base n) v) definitions results with
      | Some slopes => forallb (fun d => peq (fst d) (Pc 0%Q)) slopes
      | None => false
      end
  end end.

Theorem stationary_by xs direction divisors definitions results F :
  still (length xs) divisors direction definitions results = true ->
  all (map (fun d => eval xs d <> 0) divisors) ->
  (forall x, length x = length xs -> F x = program definitions results x) ->
  stationary F xs (map (eval xs) direction).
Proof.
  unfold still. rewrite all_map. intros H Hd E i.
  destruct (polynomials _ divisors) as [ps|] eqn:Ed; [|discriminate].
  destruct (traverse (normal ps _) direction) as [v|] eqn:Ev; [|discriminate].
  apply andb_prop in H as [L H]. apply Nat.eqb_eq in L.
  destruct (derived _ _ _ _ _ _ _ definitions results) as [slopes|] eqn:D; [|discriminate].
  pose proof (polynomials_regular xs divisors ps Ed Hd) as Rps.
  assert (faithful xs ps xs (base (length xs))) as B by (rewrite <- (app_nil_r xs) at 2; apply base_faithful).
  assert (length (base (length xs)) = length xs) as Lb by (unfold base; now rewrite map_length, seq_length).
  pose proof (derived_sound fraction (meaning xs ps) fconstant (fadd ps) fmul fopp (fdiv ps)
    (meaning_constant xs ps Rps) (meaning_add xs ps Rps) (meaning_mul xs ps Rps) (meaning_opp xs ps)
    (meaning_div xs ps Rps)
    xs (map (eval xs) direction) (combine (base (length xs)) v) definitions results slopes F) as S.
  assert (length direction = length xs) as Ldir by now rewrite <- (traverse_length _ _ _ Ev).
  replace 0 with (List.nth i (map (meaning xs ps) slopes) 0).
  - apply S; [now rewrite map_length| | | |assumption].
    + rewrite combine_length. lia.
    + intros k u U. destruct u as [a b].
      assert (nth_error (base (length xs)) k = Some a /\ nth_error v k = Some b) as [Ua Ub].
      { clear - U. revert k v U. induction (base (length xs)) as [|c l IH]; intros [|k] [|d v] U; try discriminate;
          simpl in *; [now injection U as -> ->|auto]. }
      split; cbn [fst snd]; [now apply B|].
      destruct (traverse_nth _ _ _ _ _ Ev Ub) as (e & Ee & Ne).
      rewrite (nth_error_nth (map (eval xs) direction) k 0 (x := eval xs e)) by now rewrite nth_error_map, Ee.
      now apply (normal_sound xs ps Rps xs _ B).
    + intro t. apply E, length_moved. now rewrite map_length.
  - destruct (nth_error slopes i) as [d|] eqn:U.
    + rewrite (nth_error_nth (map (meaning xs ps) slopes) i 0 (x := meaning xs ps d)) by now rewrite nth_error_map, U.
      rewrite forallb_forall in H. apply meaning_zero. apply H. now apply nth_error_In with i.
    + apply nth_error_None in U. apply List.nth_overflow. now rewrite map_length.
Qed.

(** ** At a rational point *)

Definition qquotient (a b : Q) (_ : Q) (_ : list Z) : option Q := if Qeq_bool b 0 then None else Some (Qred (a / b)).
Definition qbasis (n k : nat) : list Q := map (fun j => if Nat.eqb j k then 1%Q else 0%Q) (seq 0 n).

Definition qderived (point : list Q) (definitions results : list expr) (k : nat) : option (list Q) :=
  derived Q (fun c => c) qadd qmul Qopp qquotient (combine point (qbasis (length point) k)) definitions results.

Definition jacobian_regular (point : list Q) (definitions results : list expr) (variables : list nat) : bool :=
  match traverse (qderived point definitions results) variables with Some m => invertible m | None => false end.

Lemma qquotient_real a b c h q : qquotient a b c h = Some q -> Q2R b <> 0 /\ Q2R q = Q2R a / Q2R b.
Proof.
  unfold qquotient. destruct (Qeq_bool b 0) eqn:E; [discriminate|]. intro H.
  assert (q = Qred (a / b)) as -> by congruence. split; [now apply Q2R_nonzero|]. rewrite Q2R_red, Q2R_div; [reflexivity|now apply Qeq_bool_neq].
Qed.

Lemma Q2R_sum a b : Q2R (qadd a b) = Q2R a + Q2R b.
Proof. unfold qadd. now rewrite Q2R_red, Q2R_plus. Qed.
Lemma Q2R_product a b : Q2R (qmul a b) = Q2R a * Q2R b.
Proof. unfold qmul. now rewrite Q2R_red, Q2R_mult. Qed.

Lemma qbasis_real n k : map Q2R (qbasis n k) = basis n k.
Proof.
  unfold qbasis, basis. rewrite map_map. apply map_ext. intro j. destruct (Nat.eqb j k); [exact Q2R_1|exact Q2R_0].
Qed.

Theorem regular_at point definitions results variables F :
  jacobian_regular point definitions results variables = true ->
  (forall x, length x = length point -> F x = program definitions results x) ->
  regular_derivatives F (map Q2R point) variables.
Proof.
  unfold jacobian_regular. intros H E.
  destruct (traverse _ variables) as [m|] eqn:M; [|discriminate].
  exists (map (map Q2R) m). split; [|now apply invertible_regular].
  - clear H. revert m M. induction variables as [|k rest IH]; simpl; intros m M; [injection M as <-; constructor|].
    destruct (qderived point definitions results k) as [slopes|] eqn:D; [|discriminate].
    destruct (traverse _ rest) as [ms|]; [|discriminate]. injection M as <-. constructor; [|now apply IH].
    rewrite map_length, <- qbasis_real.
    apply (derived_sound Q Q2R (fun c => c) qadd qmul Qopp qquotient (fun c => eq_refl) Q2R_sum Q2R_product Q2R_opp
      qquotient_real) with
      (values := combine point (qbasis (length point) k)) (definitions := definitions) (results := results);
      try assumption.
    + unfold qbasis. now rewrite !map_length, seq_length.
    + unfold qbasis. rewrite combine_length, !map_length, seq_length. lia.
    + intros j [a b] U.
      assert (nth_error point j = Some a /\ nth_error (qbasis (length point) k) j = Some b) as [Ua Ub].
      { clear - U. revert j U. generalize (qbasis (length point) k). induction point as [|c l IH];
          intros [|d v] [|j] U; try discriminate; simpl in *; [now injection U as -> ->|eauto]. }
      split; apply nth_error_nth; now apply map_nth_error.
    + intro t. apply E. rewrite length_moved; rewrite ?map_length; [reflexivity|].
      unfold qbasis. now rewrite map_length, seq_length.
Qed.
