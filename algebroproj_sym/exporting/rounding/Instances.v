(** Arguments for which the hypotheses hold: a theorem about them says something. *)

From Coq Require Import Reals ZArith NArith QArith Qreals Qabs PArith FunctionalExtensionality List Bool FMapPositive Lia Lra.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Algebroproj Require Import Rounding Checker Ranges Machine.
From Algebroproj Require Elimination Formulas.

Import ListNotations.
Open Scope R_scope.

(** ** Exact values and magnitudes at a rational point *)

Definition quantities := PositiveMap.t (Q * Q).

Definition quantity (known : quantities) (j : positive) : Q * Q :=
  match PositiveMap.find j known with Some q => q | None => (0%Q, 0%Q) end.

Definition evaluated (input : positive -> Q) (known : quantities) (o : operation) : Q * Q :=
  let x j := fst (quantity known j) in
  let m j := snd (quantity known j) in
  match o with
  | Input j => (input j, Qabs (input j))
  | Constant z => (inject_Z z, Qabs (inject_Z z))
  | Neg a => (Qopp (x a), m a)
  | Add a b => (Qred (x a + x b), Qred (m a + m b))
  | Join a b => (Qred (x a + x b), m a)
  | Sub a b => (Qred (x a - x b), Qred (m a + m b))
  | Mul a b => (Qred (x a * x b), Qred (m a * m b))
  | Div a b => (Qred (x a / x b), Qred (m a * m b / (x b * x b)))
  | ProductError a b p => (Qred (x a * x b - x p), Qred (m a * m b + m p))
  end.

Fixpoint evaluation (input : positive -> Q) (p : program) (known : quantities) : quantities :=
  match p with
  | [] => known
  | (i, o) :: q => evaluation input q (PositiveMap.add i (evaluated input known o) known)
  end.

Lemma Q2R_div' a b : Q2R (a / b) = Q2R a / Q2R b.
Proof.
  unfold Qdiv, Rdiv. rewrite Q2R_mult. f_equal. destruct (Qeq_dec b 0) as [E | E]; [|now apply Q2R_inv].
  rewrite (Qeq_eqR b 0 E). unfold Q2R at 2. simpl. rewrite Rmult_0_l, Rinv_0.
  destruct b as [[|n|n] d]; unfold Qeq in E; simpl in E; try discriminate. unfold Q2R; simpl. ring.
Qed.

Definition represents (known : quantities) (x m : values) : Prop :=
  forall j, x j = Q2R (fst (quantity known j)) /\ m j = Q2R (snd (quantity known j)).

Lemma quantity_add i q known j : quantity (PositiveMap.add i q known) j = if Pos.eqb j i then q else quantity known j.
Proof.
  unfold quantity. destruct (Pos.eqb_spec j i) as [-> | N]; [now rewrite PositiveMap.gss | now rewrite PositiveMap.gso].
Qed.

Lemma evaluated_represents point input full known x m o :
  (forall j, input j = Q2R (point j)) -> (forall b, In b (operands o) -> full b = x b) -> represents known x m ->
  value input x o = Q2R (fst (evaluated point known o)) /\ size input full m o = Q2R (snd (evaluated point known o)).
Proof.
  intros I F H. assert (Hx := fun j => proj1 (H j)). assert (Hm := fun j => proj2 (H j)).
  assert (Integer : forall z, IZR z = Q2R (inject_Z z)) by (intros z; unfold Q2R; simpl; lra).
  destruct o; cbn [value size evaluated fst snd]; rewrite ?Elimination.Q2R_red, ?F by (simpl; auto);
    rewrite ?Q2R_div', <- ?Formulas.Q2R_absolute, ?Q2R_minus, ?Q2R_plus, ?Q2R_mult, ?Q2R_opp, <- ?Hx, <- ?Hm, <- ?I, <- ?Integer;
    rewrite ?Q2R_plus, ?Q2R_mult, ?Q2R_opp, <- ?Hx, <- ?Hm; auto.
Qed.

Lemma evaluation_represents point input full p :
  (forall j, input j = Q2R (point j)) -> forall n known x m,
  well_formed n p = true -> full = run (value input) p x -> represents known x m ->
  represents (evaluation point p known) (run (value input) p x) (run (size input full) p m).
Proof.
  intros I. induction p as [|[i o] q IH]; intros n known x m W F H; [exact H|].
  assert (B := proj1 (well_formed_operation _ _ i o W (or_introl eq_refl))). simpl in W, F |- *.
  apply andb_prop in W as [_ W]. apply (IH (Pos.succ i)); [exact W | exact F |]. intros j. rewrite quantity_add.
  destruct (Pos.eqb j i); [|apply H]. apply evaluated_represents; try assumption. intros b Ib. specialize (B b Ib).
  rewrite F, (run_before _ _ _ _ _ W) by lia. destruct (Pos.eqb_spec b i); [lia | reflexivity].
Qed.

(** ** Integers for which a program is determined *)

Definition term_of (known : quantities) (term : positive * N) : Q :=
  let q := quantity known (fst term) in
  inject_Z (Z.of_N (snd term)) * (1 # 1048576) * ((1 # 9007199254740992) * (1 # 9007199254740992)) * Qabs (snd q / fst q).

Definition total_of (known : quantities) (t : terms) : Q :=
  fold_right (fun term sum => Qred (term_of known term + sum)) 0%Q t.

Definition deviation_of (known : quantities) (k : N) (t : terms) : Q :=
  Qred (inject_Z (Z.of_N k) * (1 # 9007199254740992) + total_of known t).

Definition applies_to (known : quantities) (b : bound) : bool :=
  forallb (fun term => negb (Qeq_bool (fst (quantity known (fst term))) 0)) (snd (snd b))
  && negb (Qle_bool 1 (deviation_of known (fst (snd b)) (snd (snd b)))).

Definition is_instance (k : Z) (p : program) (bounds divisors : list bound) (integers : list Z) : bool :=
  let known := evaluation (fun j => inject_Z (nth (Nat.pred (Pos.to_nat j)) integers 0%Z)) p (PositiveMap.empty _) in
  well_formed 1 p && (0 <=? k)%Z && forallb (fun n => (Z.abs n <=? 2 ^ Z.min k 53)%Z) integers
  && forallb (applies_to known) (divisors ++ bounds)
  && forallb (fun d => negb (Qeq_bool (fst (quantity known (fst d))) 0)) divisors.

Lemma total_represents known x m t : represents known x m -> total x m t = Q2R (total_of known t).
Proof.
  intros H. induction t as [|[j n] t IH]; cbn [total total_of fold_right]; [unfold Q2R; simpl; lra|].
  rewrite Elimination.Q2R_red, Q2R_plus. fold (total_of known t). rewrite <- IH. f_equal. unfold term_of. cbn [fst snd].
  rewrite !Q2R_mult, <- Formulas.Q2R_absolute, Q2R_div', <- (proj1 (H j)), <- (proj2 (H j)), c_value, u_value. unfold kappa.
  f_equal. unfold Q2R; simpl. lra.
Qed.

Lemma applies_represents known input p b :
  represents known (exact input p) (magnitude input p) -> applies_to known b = true -> applies input p b.
Proof.
  intros H A. apply andb_prop in A as [A1 A2]. split.
  - apply Forall_forall. intros term T. rewrite forallb_forall in A1. specialize (A1 term T). rewrite (proj1 (H _)).
    apply negb_true_iff, Qeq_bool_neq in A1. intros E. apply A1, eqR_Qeq. rewrite E. unfold Q2R; simpl; lra.
  - apply negb_true_iff in A2. unfold deviation. rewrite (total_represents known) by exact H.
    assert (E : roundings (fst (snd b)) * u + Q2R (total_of known (snd (snd b))) = Q2R (deviation_of known (fst (snd b)) (snd (snd b)))).
    { unfold deviation_of. rewrite Elimination.Q2R_red, Q2R_plus, Q2R_mult. f_equal. rewrite u_value.
      unfold roundings, Q2R; simpl. lra. }
    rewrite E. replace 1 with (Q2R 1) by (unfold Q2R; simpl; lra). apply Qlt_Rlt, Qnot_le_lt. intros L.
    apply Qle_bool_iff in L. congruence.
Qed.

Definition machine_integer (z : Z) : binary64 := binary_normalize 53 1024 _ _ mode_NE z 0 false.

Lemma machine_integer_holds z : (Z.abs z <= 2 ^ 53)%Z -> holds (IZR z) (machine_integer z).
Proof.
  intros H. assert (F := float_constant z H).
  assert (R := machine_step (fun _ => B754_zero false) (fun _ => B754_zero false) nothing (Constant z)).
  simpl in R. rewrite RN_float in R by exact F. apply R; try easy.
  - unfold small. apply Rle_lt_trans with (power 53); [|apply bpow_lt; lia]. rewrite <- abs_IZR. unfold power.
    rewrite <- (IZR_Zpower radix2 53) by lia. now apply IZR_le.
  - now apply Z.leb_le.
Qed.

Theorem is_instance_sound k p bounds divisors integers :
  is_instance k p bounds divisors integers = true ->
  let given := map machine_integer integers in
  Forall (argument k) given /\ Forall (determined (numbers (map B2R given)) p) divisors
  /\ Forall (applies (numbers (map B2R given)) p) bounds.
Proof.
  intros H given. rewrite <- real_arguments. unfold is_instance in H. apply andb_prop in H as [H H5]. apply andb_prop in H as [H H4].
  apply andb_prop in H as [H H3]. apply andb_prop in H as [W K]. apply Z.leb_le in K. cbv zeta in H4, H5.
  rewrite forallb_forall in H3, H4, H5.
  assert (Small : forall n, In n integers -> (Z.abs n <= 2 ^ k)%Z /\ holds (IZR n) (machine_integer n)).
  { intros n I. specialize (H3 n I). apply Z.leb_le in H3. split.
    - apply Z.le_trans with (1 := H3). apply Z.pow_le_mono_r; lia.
    - apply machine_integer_holds. apply Z.le_trans with (1 := H3). apply Z.pow_le_mono_r; lia. }
  set (q := fun j => inject_Z (nth (Nat.pred (Pos.to_nat j)) integers 0%Z)) in *.
  assert (I : forall j, real (arguments given) j = Q2R (q j)).
  { intros j. unfold real, arguments, q, given. generalize (Nat.pred (Pos.to_nat j)).
    clear - Small. induction integers as [|n integers IH]; intros [|i]; simpl;
      try (unfold Q2R; simpl; lra).
    - destruct (Small n) as (_ & _ & ->); [now left|]. unfold Q2R; simpl; lra.
    - apply IH. intros n' I'. apply Small. now right. }
  assert (R := evaluation_represents q _ _ p I 1 (PositiveMap.empty _) nothing nothing W eq_refl).
  assert (R0 : represents (PositiveMap.empty _) nothing nothing).
  { intros j. unfold quantity. rewrite PositiveMap.gempty. unfold nothing, Q2R; simpl; lra. }
  specialize (R R0). fold (exact (real (arguments given)) p) in R. fold (magnitude (real (arguments given)) p) in R.
  assert (A : forall b, In b (divisors ++ bounds) -> applies (real (arguments given)) p b).
  { intros b B. now apply applies_represents with (1 := R), H4. }
  split; [|split].
  - apply Forall_map, Forall_forall. intros n N. destruct (Small n N) as (S & F & V). split; [exact F|]. rewrite V.
    destruct (Z.eq_dec n 0) as [-> | Z]; [now left | right]. rewrite <- abs_IZR. split.
    + apply Rle_trans with (power 0); [apply power_le; lia | apply IZR_le; lia].
    + unfold power. rewrite <- IZR_Zpower by lia. now apply IZR_le.
  - apply Forall_forall. intros d D. split; [|apply A, in_or_app; now left]. specialize (H5 d D).
    rewrite (proj1 (R _)). apply negb_true_iff, Qeq_bool_neq in H5. intros E. apply H5, eqR_Qeq. rewrite E.
    unfold Q2R; simpl; lra.
  - apply Forall_forall. intros b B. apply A, in_or_app. now right.
Qed.

(** ** Integers at which the machine overflows and underflows nowhere *)

Definition number_at (known : PositiveMap.t binary64) (j : positive) : binary64 :=
  match PositiveMap.find j known with Some x => x | None => B754_zero false end.

Fixpoint evaluated_by_machine (input : positive -> binary64) (p : program) (known : PositiveMap.t binary64) :=
  match p with
  | [] => known
  | (i, o) :: q => evaluated_by_machine input q (PositiveMap.add i (machine_value input (number_at known) o) known)
  end.

Lemma evaluated_by_machine_run input p :
  forall known, number_at (evaluated_by_machine input p known) = run (machine_value input) p (number_at known).
Proof.
  induction p as [|[i o] p IH]; intros known; [reflexivity|]. simpl. rewrite IH. f_equal. apply functional_extensionality.
  intros j. unfold number_at. destruct (Pos.eqb_spec j i) as [-> | N]; [now rewrite PositiveMap.gss | now rewrite PositiveMap.gso].
Qed.

(** Exponents between which a number is, unless it is zero. *)
Definition extent (x : binary64) : option (Z * Z) :=
  match x with B754_finite _ m e _ => Some (e, e + Z.log2_up (Zpos m))%Z | _ => None end.

Definition product_above (least : Z) (x y : binary64) : bool :=
  match extent x, extent y with Some (l, _), Some (l', _) => (least <=? l + l')%Z | _, _ => true end.

Definition quotient_above (least : Z) (x y : binary64) : bool :=
  match extent x, extent y with Some (l, _), Some (_, h) => (least <=? l - h)%Z | _, None => false | None, _ => true end.

Definition regular_at (e : positive -> binary64) (o : operation) : bool :=
  match o with
  | Mul a b => product_above (-1022) (e a) (e b)
  | Div a b => quotient_above (-1022) (e a) (e b)
  | ProductError a b _ => product_above (-969) (e a) (e b)
  | _ => true
  end.

Lemma extent_holds x :
  match extent x with Some (l, h) => B2R x <> 0 /\ power l <= Rabs (B2R x) <= power h | None => B2R x = 0 end.
Proof.
  destruct x as [s | s | | s m e B]; try reflexivity. simpl. assert (P := bpow_gt_0 radix2 e).
  assert (A : Rabs (F2R (Float radix2 (SpecFloat.cond_Zopp s (Zpos m)) e)) = IZR (Zpos m) * power e).
  { rewrite <- F2R_Zabs. destruct s; reflexivity. }
  assert (M : 1 <= IZR (Zpos m) <= power (Z.log2_up (Zpos m))).
  { split; [apply IZR_le; lia|]. unfold power. rewrite <- IZR_Zpower by apply Z.log2_up_nonneg. apply IZR_le.
    destruct (Pos.eq_dec m 1) as [-> | N]; [simpl; lia|]. apply Z.log2_up_spec. lia. }
  split; [apply F2R_neq_0; simpl; now destruct s|]. rewrite A. unfold power in *. rewrite bpow_plus. split.
  - rewrite <- (Rmult_1_l (bpow radix2 e)) at 1. apply Rmult_le_compat_r; lra.
  - rewrite Rmult_comm. apply Rmult_le_compat_l; lra.
Qed.

Lemma product_above_holds least x y :
  product_above least x y = true -> B2R x * B2R y = 0 \/ power least <= Rabs (B2R x * B2R y).
Proof.
  intros H. assert (X := extent_holds x). assert (Y := extent_holds y). unfold product_above in H.
  destruct (extent x) as [[l h]|]; [|left; rewrite X; ring]. destruct (extent y) as [[l' h']|]; [|left; rewrite Y; ring].
  right. apply Z.leb_le in H. apply Rle_trans with (power (l + l')); [now apply power_le|].
  unfold power. rewrite bpow_plus, Rabs_mult. apply Rmult_le_compat; try apply bpow_ge_0; [apply X | apply Y].
Qed.

Lemma quotient_above_holds least x y :
  quotient_above least x y = true -> B2R y <> 0 /\ (B2R x / B2R y = 0 \/ power least <= Rabs (B2R x / B2R y)).
Proof.
  intros H. assert (X := extent_holds x). assert (Y := extent_holds y). unfold quotient_above in H.
  destruct (extent y) as [[l' h']|]; [|destruct (extent x) as [[l h]|]; discriminate]. destruct Y as (N & Y). split; [exact N|].
  destruct (extent x) as [[l h]|]; [|left; rewrite X; unfold Rdiv; ring]. right. apply Z.leb_le in H.
  apply Rle_trans with (power (l - h')); [now apply power_le|]. destruct X as (_ & X).
  unfold Rdiv, Z.sub, power. rewrite bpow_plus, Rabs_mult. apply Rmult_le_compat; try apply bpow_ge_0; [apply X|].
  now apply (within_inv l' h' _ N (or_intror (proj1 Y))).
Qed.

Definition runs (p : program) (integers : list Z) : bool :=
  let known := evaluated_by_machine (arguments (map machine_integer integers)) p (PositiveMap.empty _) in
  well_formed 1 p && forallb (fun n => (Z.abs n <=? 2 ^ 53)%Z) integers
  && forallb (fun named => is_finite (number_at known (fst named)) && regular_at (number_at known) (snd named)) p.

Theorem runs_sound p integers :
  runs p integers = true ->
  let given := map machine_integer integers in
  all_finite given p /\ all_regular (numbers (map B2R given)) p.
Proof.
  intros H given. unfold runs in H. cbv zeta in H. fold given in H. apply andb_prop in H as [H R]. apply andb_prop in H as [W I].
  rewrite forallb_forall in I, R. rewrite evaluated_by_machine_run in R.
  assert (E : number_at (PositiveMap.empty _) = fun _ => B754_zero false).
  { apply functional_extensionality. intros j. unfold number_at. now rewrite PositiveMap.gempty. }
  rewrite E in R. fold (machine (arguments given) p) in R.
  assert (G : Forall (fun x => is_finite x = true) given).
  { apply Forall_map, Forall_forall. intros n N. apply machine_integer_holds, Z.leb_le, I, N. }
  assert (F : all_finite given p).
  { split; [exact G|]. apply Forall_forall. intros named N. specialize (R named N). now apply andb_prop in R as [R _]. }
  split; [exact F|]. rewrite <- real_arguments.
  assert (M : forall i, holds (computed (real (arguments given)) p i) (machine (arguments given) p i)).
  { apply machine_computes; [exact W | now apply arguments_finite |]. intros i o N. assert (Q := R (i, o) N).
    apply andb_prop in Q as [R1 R2]. split; [now right|]. destruct o; try exact Logic.I. right.
    now apply quotient_above_holds in R2. }
  apply Forall_forall. intros [i o] N. specialize (R (i, o) N). apply andb_prop in R as [_ R]. simpl in R |- *.
  destruct o as [| | | | | | a b | a b | a b q]; try exact Logic.I; simpl in R |- *;
    rewrite <- (proj2 (M a)), <- (proj2 (M b)).
  - apply product_above_holds in R. destruct R as [-> | R]; [left; apply float_0 | now right].
  - apply quotient_above_holds in R as (_ & [-> | R]); [left; apply float_0 | now right].
  - now apply product_above_holds.
Qed.
