(** What a program computes in binary64, where numbers overflow and underflow. *)

From Coq Require Import Reals ZArith NArith PArith Wf_nat FunctionalExtensionality List Bool FMapPositive Lia Lra.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Algebroproj Require Import Rounding Checker Ranges.

Import ListNotations.
Open Scope R_scope.

(** ** Programs of machine numbers *)

Definition binary64 := binary_float 53 1024.

#[global] Instance fewer_digits : Prec_lt_emax 53 1024.
Proof. reflexivity. Qed.

Definition machine_value (input e : positive -> binary64) (o : operation) : binary64 :=
  match o with
  | Input k => input k
  | Constant z => binary_normalize 53 1024 _ _ mode_NE z 0 false
  | Neg a => Bopp (e a)
  | Add a b | Join a b => Bplus mode_NE (e a) (e b)
  | Sub a b => Bminus mode_NE (e a) (e b)
  | Mul a b => Bmult mode_NE (e a) (e b)
  | Div a b => Bdiv mode_NE (e a) (e b)
  | ProductError a b p => Bfma mode_NE (e a) (e b) (Bopp (e p))
  end.

Definition machine (input : positive -> binary64) (p : program) : positive -> binary64 :=
  run (machine_value input) p (fun _ => B754_zero false).

Definition real (input : positive -> binary64) : values := fun j => B2R (input j).

Lemma local_machine input : local (machine_value input).
Proof. intros e e' [] H; simpl in *; rewrite ?(H a), ?(H b), ?(H p); auto. Qed.

(** A finite number with a value. *)
Definition holds (v : R) (x : binary64) : Prop := is_finite x = true /\ B2R x = v.

Lemma float_B2R (x : binary64) : is_float (B2R x).
Proof. exact (generic_format_B2R 53 1024 x). Qed.

Lemma machine_step (input e : positive -> binary64) (f : values) o :
  (forall j, is_finite (input j) = true) -> (forall a, In a (operands o) -> holds (f a) (e a)) ->
  small (RN (value (real input) f o)) -> match o with Div _ b => f b <> 0 | _ => True end ->
  is_representable o = true -> holds (RN (value (real input) f o)) (machine_value input e o).
Proof.
  intros I E S D C. apply Rlt_bool_true in S.
  assert (Both : forall a b, (forall c, In c [a; b] -> holds (f c) (e c)) ->
    (is_finite (e a) = true /\ B2R (e a) = f a) /\ is_finite (e b) = true /\ B2R (e b) = f b).
  { intros a b H. split; apply H; simpl; auto. }
  destruct o as [j | z | a | a b | a b | a b | a b | a b | a b p]; simpl operands in E; cbn [value] in S |- *; cbn [machine_value].
  - split; [apply I|]. symmetry. apply RN_float, float_B2R.
  - assert (H := binary_normalize_correct 53 1024 _ _ mode_NE z 0 false). cbv zeta in H.
    unfold F2R in H. simpl Fnum in H. simpl Fexp in H. change (bpow radix2 0) with 1 in H. rewrite Rmult_1_r in H.
    change (round _ _ _ (IZR z)) with (RN (IZR z)) in H. fold power in H. rewrite S in H. split; apply H.
  - destruct (E a) as (Fa & Va); [now left|]. split; [now rewrite is_finite_Bopp|].
    rewrite B2R_Bopp, Va, RN_opp, RN_float; [reflexivity|]. rewrite <- Va. apply float_B2R.
  - destruct (Both a b E) as ((Fa & Va) & Fb & Vb). assert (H := Bplus_correct 53 1024 _ _ mode_NE _ _ Fa Fb).
    rewrite Va, Vb in H. change (round _ _ _ (f a + f b)) with (RN (f a + f b)) in H. fold power in H. rewrite S in H.
    split; apply H.
  - destruct (Both a b E) as ((Fa & Va) & Fb & Vb). assert (H := Bplus_correct 53 1024 _ _ mode_NE _ _ Fa Fb).
    rewrite Va, Vb in H. change (round _ _ _ (f a + f b)) with (RN (f a + f b)) in H. fold power in H. rewrite S in H.
    split; apply H.
  - destruct (Both a b E) as ((Fa & Va) & Fb & Vb). assert (H := Bminus_correct 53 1024 _ _ mode_NE _ _ Fa Fb).
    rewrite Va, Vb in H. change (round _ _ _ (f a - f b)) with (RN (f a - f b)) in H. fold power in H. rewrite S in H.
    split; apply H.
  - destruct (Both a b E) as ((Fa & Va) & Fb & Vb). assert (H := Bmult_correct 53 1024 _ _ mode_NE (e a) (e b)).
    rewrite Va, Vb in H. change (round _ _ _ (f a * f b)) with (RN (f a * f b)) in H. fold power in H. rewrite S in H.
    destruct H as (H1 & H2 & _). rewrite Fa, Fb in H2. now split.
  - destruct (Both a b E) as ((Fa & Va) & Fb & Vb). rewrite <- Vb in D.
    assert (H := Bdiv_correct 53 1024 _ _ mode_NE (e a) (e b) D).
    rewrite Va, Vb in H. change (round _ _ _ (f a / f b)) with (RN (f a / f b)) in H. fold power in H. rewrite S in H.
    destruct H as (H1 & H2 & _). rewrite Fa in H2. now split.
  - destruct (Both a b) as ((Fa & Va) & Fb & Vb); [intros c [<- | [<- | []]]; apply E; simpl; auto|].
    destruct (E p) as (Fp & Vp); [simpl; auto|].
    assert (Fn : is_finite (Bopp (e p)) = true) by now rewrite is_finite_Bopp.
    assert (H := Bfma_correct 53 1024 _ _ mode_NE _ _ _ Fa Fb Fn). cbv zeta in H. rewrite B2R_Bopp, Va, Vb, Vp in H.
    change (round _ _ _ (f a * f b + - f p)) with (RN (f a * f b - f p)) in H. fold power in H. rewrite S in H.
    split; apply H.
Qed.

(** A finite result has not overflowed. *)
Lemma machine_small (input e : positive -> binary64) (f : values) o :
  (forall a, In a (operands o) -> holds (f a) (e a)) -> match o with Div _ b => f b <> 0 | _ => True end ->
  is_finite (machine_value input e o) = true -> small (RN (value (real input) f o)).
Proof.
  intros E D F. destruct (Rlt_or_le (Rabs (RN (value (real input) f o))) (power 1024)) as [S | S]; [exact S | exfalso].
  apply Rlt_bool_false in S. rewrite <- is_finite_SF_B2SF in F.
  assert (Both : forall a b, (forall c, In c [a; b] -> holds (f c) (e c)) ->
    (is_finite (e a) = true /\ B2R (e a) = f a) /\ is_finite (e b) = true /\ B2R (e b) = f b).
  { intros a b H. split; apply H; simpl; auto. }
  destruct o as [j | z | a | a b | a b | a b | a b | a b | a b p]; simpl operands in E; cbn [value] in S; cbn [machine_value] in F.
  - unfold real in S. rewrite RN_float in S by apply float_B2R. assert (H := abs_B2R_lt_emax 53 1024 (input j)).
    apply Rlt_bool_true in H. unfold power in S. simpl in S, H. congruence.
  - assert (H := binary_normalize_correct 53 1024 _ _ mode_NE z 0 false). cbv zeta in H.
    unfold F2R in H. simpl Fnum in H. simpl Fexp in H. change (bpow radix2 0) with 1 in H. rewrite Rmult_1_r in H.
    change (round _ _ _ (IZR z)) with (RN (IZR z)) in H. fold power in H. rewrite S in H. now rewrite H in F.
  - destruct (E a) as (Fa & Va); [now left|]. rewrite RN_opp, RN_float in S by (rewrite <- Va; apply float_B2R).
    assert (H := abs_B2R_lt_emax 53 1024 (e a)). apply Rlt_bool_true in H. rewrite Rabs_Ropp, <- Va in S.
    unfold power in S. simpl in S, H. congruence.
  - destruct (Both a b E) as ((Fa & Va) & Fb & Vb). assert (H := Bplus_correct 53 1024 _ _ mode_NE _ _ Fa Fb).
    rewrite Va, Vb in H. change (round _ _ _ (f a + f b)) with (RN (f a + f b)) in H. fold power in H. rewrite S in H.
    destruct H as (H & _). now rewrite H in F.
  - destruct (Both a b E) as ((Fa & Va) & Fb & Vb). assert (H := Bplus_correct 53 1024 _ _ mode_NE _ _ Fa Fb).
    rewrite Va, Vb in H. change (round _ _ _ (f a + f b)) with (RN (f a + f b)) in H. fold power in H. rewrite S in H.
    destruct H as (H & _). now rewrite H in F.
  - destruct (Both a b E) as ((Fa & Va) & Fb & Vb). assert (H := Bminus_correct 53 1024 _ _ mode_NE _ _ Fa Fb).
    rewrite Va, Vb in H. change (round _ _ _ (f a - f b)) with (RN (f a - f b)) in H. fold power in H. rewrite S in H.
    destruct H as (H & _). now rewrite H in F.
  - destruct (Both a b E) as ((Fa & Va) & Fb & Vb). assert (H := Bmult_correct 53 1024 _ _ mode_NE (e a) (e b)).
    rewrite Va, Vb in H. change (round _ _ _ (f a * f b)) with (RN (f a * f b)) in H. fold power in H. rewrite S in H.
    now rewrite H in F.
  - destruct (Both a b E) as ((Fa & Va) & Fb & Vb). rewrite <- Vb in D.
    assert (H := Bdiv_correct 53 1024 _ _ mode_NE (e a) (e b) D).
    rewrite Va, Vb in H. change (round _ _ _ (f a / f b)) with (RN (f a / f b)) in H. fold power in H. rewrite S in H.
    now rewrite H in F.
  - destruct (Both a b) as ((Fa & Va) & Fb & Vb); [intros c [<- | [<- | []]]; apply E; simpl; auto|].
    destruct (E p) as (Fp & Vp); [simpl; auto|].
    assert (Fn : is_finite (Bopp (e p)) = true) by now rewrite is_finite_Bopp.
    assert (H := Bfma_correct 53 1024 _ _ mode_NE _ _ _ Fa Fb Fn). cbv zeta in H. rewrite B2R_Bopp, Va, Vb, Vp in H.
    change (round _ _ _ (f a * f b + - f p)) with (RN (f a * f b - f p)) in H. fold power in H. rewrite S in H.
    now rewrite H in F.
Qed.

Lemma above p : forall n i o, well_formed n p = true -> In (i, o) p -> (n <= i)%positive.
Proof.
  induction p as [|[j k] q IH]; intros n i o W I; [contradiction|]. simpl in *.
  apply andb_prop in W as [W Wq]. apply andb_prop in W as [W _]. apply andb_prop in W as [W _]. apply Pos.leb_le in W.
  destruct I as [E | I]; [now injection E as <- <-|]. apply (IH _ _ _ Wq) in I. lia.
Qed.

Lemma table_find p : forall n i o, well_formed n p = true -> In (i, o) p -> PositiveMap.find i (table p) = Some o.
Proof.
  induction p as [|[j k] q IH]; intros n i o W I; [contradiction|]. simpl in *. apply andb_prop in W as [_ Wq].
  destruct I as [E | I]; [injection E as -> ->; apply PositiveMap.gss|].
  rewrite PositiveMap.gso; [now apply (IH (Pos.succ j))|]. apply (above _ _ _ _ Wq) in I. lia.
Qed.

Lemma run_other {T} (step : (positive -> T) -> operation -> T) p :
  forall e i, PositiveMap.find i (table p) = None -> run step p e i = e i.
Proof.
  induction p as [|[j o] p IH]; intros e i H; [reflexivity|]. simpl in *. destruct (Pos.eq_dec i j) as [-> | N].
  - now rewrite PositiveMap.gss in H.
  - rewrite PositiveMap.gso in H by exact N. rewrite IH by exact H. destruct (Pos.eqb_spec i j); [contradiction | reflexivity].
Qed.

Lemma well_formed_operation p : forall n i o,
  well_formed n p = true -> In (i, o) p -> (forall a, In a (operands o) -> (a < i)%positive) /\ is_representable o = true.
Proof.
  induction p as [|[j k] q IH]; intros n i o W I; [contradiction|]. simpl in *.
  apply andb_prop in W as [W Wq]. apply andb_prop in W as [W Wr]. apply andb_prop in W as [_ Wa].
  destruct I as [E | I]; [|now apply (IH (Pos.succ j))]. injection E as -> ->. split; [|exact Wr].
  intros a A. rewrite forallb_forall in Wa. now apply Pos.ltb_lt, Wa.
Qed.

(** A result does not overflow if it is small in the model, or finite in the machine. *)
Definition no_overflow_at (input : positive -> binary64) (p : program) (i : positive) : Prop :=
  small (computed (real input) p i) \/ is_finite (machine input p i) = true.

(** Where nothing overflows and no divisor is zero, the machine has the numbers of the model. *)
Lemma machine_computes input p :
  well_formed 1 p = true -> (forall j, is_finite (input j) = true) ->
  (forall i o, In (i, o) p ->
    no_overflow_at input p i
    /\ match o with Div _ b => computed (real input) p b <> 0 \/ B2R (machine input p b) <> 0 | _ => True end) ->
  forall i, holds (computed (real input) p i) (machine input p i).
Proof.
  intros W I H i. induction i as [i IH] using (well_founded_induction (well_founded_ltof positive Pos.to_nat)).
  destruct (PositiveMap.find i (table p)) as [o|] eqn:O.
  - apply table_in in O. destruct (well_formed_operation p 1 i o W O) as (B & C). destruct (H i o O) as (S & D).
    assert (V := computed_value (real input) p i o W O). unfold no_overflow_at in S.
    assert (X : machine input p i = machine_value input (machine input p) o)
      by exact (run_value _ p (local_machine input) 1 _ i o W O). rewrite V, X in *.
    assert (Y : forall a, In a (operands o) -> holds (computed (real input) p a) (machine input p a))
      by (intros a A; apply IH, Pos2Nat.inj_lt, B, A).
    assert (Z : match o with Div _ b => computed (real input) p b <> 0 | _ => True end).
    { destruct o as [| | | | | | | a b |]; try exact Logic.I. destruct D as [D | D]; [exact D|]. now rewrite <- (proj2 (Y b (or_intror (or_introl eq_refl)))). }
    apply machine_step; try assumption. destruct S as [S | S]; [exact S|]. now apply machine_small with (machine input p).
  - unfold machine, computed. rewrite !run_other by exact O. split; reflexivity.
Qed.

(** ** Arguments in a range *)

Definition arguments (given : list binary64) : positive -> binary64 :=
  fun j => nth (Nat.pred (Pos.to_nat j)) given (B754_zero false).

Definition numbers (given : list R) : values := fun j => nth (Nat.pred (Pos.to_nat j)) given 0.

(** The machine gives a number, no infinity, and where a bound applies, it is as near the value [y] as that says. *)
Definition accurate (given : list binary64) (p : program) (b : bound) (y : R) : Prop :=
  let v := machine (arguments given) p (fst b) in
  let x := numbers (map B2R given) in
  let t := deviation (exact x p) (magnitude x p) (fst (snd b)) (snd (snd b)) in
  is_finite v = true /\ (applies x p b -> Rabs (B2R v - y) <= t / (1 - t) * Rabs y).

Definition check_range (k : Z) (p : program) (cert : list command) (bounds divisors : list bound) : bool :=
  check p cert bounds divisors && fits (table p) k (PositiveMap.empty _) p.

Definition argument (k : Z) (x : binary64) : Prop := is_finite x = true /\ in_range k (B2R x).

Lemma real_arguments given : real (arguments given) = numbers (map B2R given).
Proof. apply functional_extensionality. intros j. symmetry. exact (map_nth B2R given (B754_zero false) _). Qed.

Lemma arguments_finite (given : list binary64) :
  Forall (fun x => is_finite x = true) given -> forall j, is_finite (arguments given j) = true.
Proof.
  intros H j. unfold arguments. destruct (nth_in_or_default (Nat.pred (Pos.to_nat j)) given (B754_zero false)) as [I | ->];
    [|reflexivity]. rewrite Forall_forall in H. now apply H.
Qed.

Lemma arguments_in k given : Forall (argument k) given -> forall j, argument k (arguments given j).
Proof.
  intros H j. unfold arguments. destruct (nth_in_or_default (Nat.pred (Pos.to_nat j)) given (B754_zero false)) as [I | ->].
  - rewrite Forall_forall in H. now apply H.
  - split; [reflexivity | now left].
Qed.

(** If nothing overflows and no product or quotient underflows, the results are as near as the bounds say. *)
Lemma check_machine p cert bounds divisors :
  check p cert bounds divisors = true ->
  forall given ys, (forall j, is_finite (arguments given j) = true) ->
  (forall named, In named p -> no_overflow_at (arguments given) p (fst named)) ->
  all_regular (numbers (map B2R given)) p -> Forall (determined (numbers (map B2R given)) p) divisors ->
  map (exact (numbers (map B2R given)) p) (map fst bounds) = ys ->
  Forall2 (accurate given p) bounds ys.
Proof.
  intros Hc given ys A S R D <-. unfold accurate. rewrite <- real_arguments in *.
  set (input := arguments given) in *. clearbody input.
  assert (W := check_well_formed _ _ _ _ Hc). set (f := computed (real input) p). assert (Q := check_divisors _ _ _ _ Hc).
  assert (F := check_factors _ _ _ _ Hc (real input) (fun j => float_B2R (input j)) R D).
  rewrite Forall_forall in D. apply Forall_app in F as [Fd Fb]. rewrite Forall_forall in Fd.
  assert (M : forall i, holds (f i) (machine input p i)).
  { apply machine_computes; [exact W | exact A |]. intros i o O. split; [exact (S _ O)|].
    destruct o; try exact I. destruct (Q _ _ _ O) as (d & Id & <-). destruct (D _ Id) as (X & Z & L). cbv zeta in L.
    destruct (Fd _ Id Z L) as (q & E & G). fold f in E. left. change (f (fst d) <> 0). rewrite E. assert (P := factor_pos _ _ L G).
    intros N. apply Rmult_integral in N. destruct N; [now apply X | lra]. }
  rewrite map_map. clear Hc. induction Fb as [|b bounds G _ IH]; constructor; [|exact IH]. destruct (M (fst b)) as (M1 & M2). split; [exact M1|]. intros (Z & L).
  rewrite M2. now apply factor_error.
Qed.

(** Every result of the lines is a finite number. *)
Definition all_finite (given : list binary64) (p : program) : Prop :=
  Forall (fun x => is_finite x = true) given
  /\ Forall (fun named => is_finite (machine (arguments given) p (fst named)) = true) p.

Theorem check_finite p cert bounds divisors :
  check p cert bounds divisors = true ->
  forall given ys, all_finite given p -> all_regular (numbers (map B2R given)) p ->
  Forall (determined (numbers (map B2R given)) p) divisors ->
  map (exact (numbers (map B2R given)) p) (map fst bounds) = ys ->
  Forall2 (accurate given p) bounds ys.
Proof.
  intros H given ys (A & F). apply (check_machine _ _ _ _ H).
  - now apply arguments_finite.
  - intros named I. right. rewrite Forall_forall in F. now apply F.
Qed.

Theorem check_range_sound k p cert bounds divisors :
  check_range k p cert bounds divisors = true ->
  forall given ys, Forall (argument k) given -> Forall (determined (numbers (map B2R given)) p) divisors ->
  map (exact (numbers (map B2R given)) p) (map fst bounds) = ys ->
  Forall2 (accurate given p) bounds ys.
Proof.
  intros H given ys G. assert (A := arguments_in k given G). unfold check_range in H. apply andb_prop in H as [Hc Hf].
  assert (W := check_well_formed _ _ _ _ Hc). set (input := arguments given) in *.
  assert (T : forall i o, PositiveMap.find i (table p) = Some o -> In (i, o) p) by apply table_in.
  assert (S : Forall (fun named => small (computed (real input) p (fst named)) /\ regular (computed (real input) p) (snd named)) p).
  { apply (fits_sound (table p) k (real input) (computed (real input) p)) with (known := PositiveMap.empty _).
    - intros i o O. now apply computed_value, T.
    - apply float_computed.
    - intros j. apply float_B2R.
    - intros j. apply A.
    - intros i z O. apply float_constant. now apply (well_formed_constant p 1 i z W), T.
    - intros j t E. rewrite PositiveMap.gempty in E. discriminate.
    - intros i o O. now apply (table_find p 1).
    - exact Hf. }
  apply (check_machine _ _ _ _ Hc).
  - intros j. apply A.
  - intros named I. left. rewrite Forall_forall in S. now apply S.
  - rewrite <- real_arguments. exact (Forall_impl _ (fun named => @proj2 _ _) S).
Qed.

(** The same certificate is one for all arguments without overflow and underflow. *)
Theorem check_range_bounds k p cert bounds divisors :
  check_range k p cert bounds divisors = true ->
  forall input, (forall j, is_float (input j)) -> all_regular input p -> Forall (determined input p) divisors ->
  Forall (bounded input p) bounds.
Proof. intros H. apply andb_prop in H as [H _]. now apply check_sound with cert. Qed.
