(** Powers of two between which the numbers of a program lie: then nothing overflows or underflows. *)

From Coq Require Import Reals ZArith NArith PArith List Bool FMapPositive Lia Lra.
From Flocq Require Import Core Relative.
From Algebroproj Require Import Rounding Checker.

Import ListNotations.
Open Scope R_scope.

(** ** Exponents *)

(** Numbers are multiples of [2^grid], at most [2^high], and unless they are zero at least [2^low]. *)
Inductive exponents := Zero | Between (grid low high : Z).

Definition power := bpow radix2.
Definition multiple (g : Z) := generic_format radix2 (FIX_exp g).
Definition at_least (l : Z) (v : R) := v = 0 \/ power l <= Rabs v.

Definition within (s : exponents) (v : R) : Prop :=
  match s with
  | Zero => v = 0
  | Between g l h => multiple g v /\ at_least l v /\ Rabs v <= power h
  end.

Lemma multiple_integer g v : multiple g v <-> exists n, v = IZR n * power g.
Proof.
  split.
  - intros H. exists (Ztrunc (scaled_mantissa radix2 (FIX_exp g) v)). exact H.
  - intros (n & ->). apply generic_format_FIX. now exists (Float radix2 n g).
Qed.

Lemma multiple_le g g' v : (g' <= g)%Z -> multiple g v -> multiple g' v.
Proof. intros H. apply generic_inclusion_mag. intros _. exact H. Qed.

Lemma multiple_add g a b : multiple g a -> multiple g b -> multiple g (a + b).
Proof. rewrite !multiple_integer. intros (m & ->) (n & ->). exists (m + n)%Z. rewrite plus_IZR. ring. Qed.

Lemma multiple_opp g a : multiple g a -> multiple g (- a).
Proof. apply generic_format_opp. Qed.

Lemma multiple_mul g g' a b : multiple g a -> multiple g' b -> multiple (g + g') (a * b).
Proof.
  rewrite !multiple_integer. intros (m & ->) (n & ->). exists (m * n)%Z. unfold power. rewrite mult_IZR, bpow_plus. ring.
Qed.

Lemma multiple_at_least g v : multiple g v -> at_least g v.
Proof.
  rewrite multiple_integer. intros (n & ->). destruct (Z.eq_dec n 0) as [-> | N]; [left; ring | right].
  assert (P := bpow_ge_0 radix2 g). fold power in P. rewrite Rabs_mult, (Rabs_right (power g)) by lra. rewrite <- abs_IZR.
  rewrite <- (Rmult_1_l (power g)) at 1. apply Rmult_le_compat_r; [exact P|]. apply IZR_le. lia.
Qed.

Lemma multiple_RN g v : multiple g v -> multiple g (RN v).
Proof. apply generic_round_generic; typeclasses eauto. Qed.

(** A float that is not small has no digits far behind the point. *)
Lemma float_multiple l v : is_float v -> at_least l v -> multiple (l - 52) v.
Proof.
  intros F [-> | L]; [apply generic_format_0|]. revert F. apply generic_inclusion_mag. intros N.
  assert (l < mag radix2 v)%Z by now apply mag_gt_bpow. unfold exponent, FLT_exp, FIX_exp. lia.
Qed.

Lemma float_power e : (-1074 <= e)%Z -> is_float (power e).
Proof. intros H. apply generic_format_bpow. unfold exponent, FLT_exp. lia. Qed.

Lemma RN_at_most h v : (-1074 <= h)%Z -> Rabs v <= power h -> Rabs (RN v) <= power h.
Proof. intros H V. apply abs_round_le_generic; try typeclasses eauto; [now apply float_power | exact V]. Qed.

Lemma RN_at_least l v : (-1074 <= l)%Z -> at_least l v -> at_least l (RN v).
Proof.
  intros H [-> | V]; [left; apply RN_float, float_0 | right].
  apply abs_round_ge_generic; try typeclasses eauto; [now apply float_power | exact V].
Qed.

Lemma power_le a b : (a <= b)%Z -> power a <= power b.
Proof. apply bpow_le. Qed.

Lemma power_pos a : 0 < power a.
Proof. apply bpow_gt_0. Qed.

Lemma at_least_mul l l' a b : at_least l a -> at_least l' b -> at_least (l + l') (a * b).
Proof.
  intros [-> | A]; [left; ring|]. intros [-> | B]; [left; ring | right]. unfold power. rewrite bpow_plus, Rabs_mult.
  apply Rmult_le_compat; try apply bpow_ge_0; assumption.
Qed.

Lemma at_most_mul h h' a b : Rabs a <= power h -> Rabs b <= power h' -> Rabs (a * b) <= power (h + h').
Proof.
  intros A B. unfold power. rewrite bpow_plus, Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; assumption.
Qed.

Lemma at_most_add h h' a b : Rabs a <= power h -> Rabs b <= power h' -> Rabs (a + b) <= power (Z.max h h' + 1).
Proof.
  intros A B. apply Rle_trans with (1 := Rabs_triang a b). unfold power in *. rewrite bpow_plus_1. simpl (IZR radix2).
  assert (G := power_le h (Z.max h h') ltac:(lia)). assert (G' := power_le h' (Z.max h h') ltac:(lia)). unfold power in *. lra.
Qed.

Lemma within_inv l h b : b <> 0 -> at_least l b -> Rabs b <= power h -> power (- h) <= Rabs (/ b) <= power (- l).
Proof.
  intros N [-> | L] H; [contradiction|]. rewrite Rabs_inv. unfold power in *. rewrite !bpow_opp.
  assert (P := bpow_gt_0 radix2 l). split; apply Rinv_le; lra.
Qed.

(** ** How exponents follow from operation to operation *)

Fixpoint twos (p : positive) : Z := match p with xO q => twos q + 1 | _ => 0 end.

Definition of_integer (z : Z) : exponents :=
  match z with
  | Z0 => Zero
  | Zpos p | Zneg p => let g := twos p in Between g g (Z.log2_up (Zpos p))
  end.

(** Powers of two below the least float would not bound what is rounded. *)
Definition limited (g l h : Z) : option exponents := guard (-1074 <=? h)%Z (Between g l h).

(** The largest numbers are smaller than [2^1024]. *)
Definition no_overflow (s : exponents) : bool := match s with Zero => true | Between _ _ h => (h <=? 1023)%Z end.

Definition of_sum (a b : exponents) : option exponents :=
  match a, b with
  | Zero, s | s, Zero => Some s
  | Between g _ h, Between g' _ h' => let least := Z.min g g' in limited least least (Z.max h h' + 1)
  end.

Definition of_product (a b : exponents) : option exponents :=
  match a, b with
  | Zero, _ | _, Zero => Some Zero
  | Between g l h, Between g' l' h' =>
      let grid := Z.max (g + g') (l + l' - 52) in
      if ((-1022 <=? l + l') || (-1074 <=? grid) && (-1074 <=? l + l'))%Z then limited grid (l + l') (h + h') else None
  end.

Definition of_quotient (a b : exponents) : option exponents :=
  match a, b with
  | _, Zero => None
  | Zero, _ => Some Zero
  | Between _ l h, Between _ l' h' =>
      if (-1022 <=? l - h')%Z then limited (l - h' - 52) (l - h') (h - l') else None
  end.

Definition of_product_error (a b : exponents) : option exponents :=
  match a, b with
  | Zero, _ | _, Zero => Some Zero
  | Between g l h, Between g' l' h' =>
      if (-969 <=? l + l')%Z then limited (g + g') (g + g') (h + h' - 53) else None
  end.

Definition both {A B : Type} (f : A -> A -> option B) (a b : option A) : option B :=
  match a, b with Some a, Some b => f a b | _, _ => None end.

Section Following.

Variable operations : PositiveMap.t operation.
Variable k : Z.

Definition found (known : PositiveMap.t exponents) (o : operation) : option exponents :=
  let of a := PositiveMap.find a known in
  match o with
  | Input _ => limited (- k - 52) (- k) k
  | Constant z => Some (of_integer z)
  | Neg a => of a
  | Add a b | Join a b | Sub a b => both of_sum (of a) (of b)
  | Mul a b => both of_product (of a) (of b)
  | Div a b => both of_quotient (of a) (of b)
  | ProductError a b p => if multiplies operations p a b then both of_product_error (of a) (of b) else None
  end.

Fixpoint fits (known : PositiveMap.t exponents) (p : program) : bool :=
  match p with
  | [] => true
  | (i, o) :: q => match found known o with Some s => no_overflow s && fits (PositiveMap.add i s known) q | None => false end
  end.

Variables (input f : values).

Definition in_range (v : R) : Prop := v = 0 \/ power (- k) <= Rabs v <= power k.

Hypothesis f_value : forall i o, PositiveMap.find i operations = Some o -> f i = RN (value input f o).
Hypothesis f_float : forall i, is_float (f i).
Hypothesis input_float : forall j, is_float (input j).
Hypothesis input_range : forall j, in_range (input j).

Definition small (v : R) : Prop := Rabs v < power 1024.

Lemma within_small s v : within s v -> no_overflow s = true -> small v.
Proof.
  destruct s as [|g l h]; simpl; [intros -> _; unfold small; rewrite Rabs_R0; apply power_pos|].
  intros (_ & _ & W) H. apply Z.leb_le in H. apply Rle_lt_trans with (1 := W). apply bpow_lt. lia.
Qed.

Lemma limited_true g l h s : limited g l h = Some s -> s = Between g l h /\ (-1074 <= h)%Z.
Proof. intros H. apply guard_true in H as [H <-]. apply Z.leb_le in H. auto. Qed.

Lemma RN_within g l h v :
  (-1074 <= h)%Z -> multiple g v -> at_least l (RN v) -> Rabs v <= power h -> within (Between g l h) (RN v).
Proof. intros H M L V. split; [now apply multiple_RN|]. split; [exact L | now apply RN_at_most]. Qed.

Lemma sum_within s a b x y : of_sum a b = Some s -> is_float x -> is_float y -> within a x -> within b y -> within s (RN (x + y)).
Proof.
  intros H Fx Fy A B. destruct a as [|g l h]; [simpl in A; subst x|destruct b as [|g' l' h']; [simpl in B; subst y|]].
  - assert (s = b) as -> by (destruct b; now injection H). rewrite Rplus_0_l, RN_float; assumption.
  - injection H as <-. rewrite Rplus_0_r, RN_float; assumption.
  - apply limited_true in H as (-> & H1). destruct A as (A1 & _ & A3), B as (B1 & _ & B3).
    assert (M : multiple (Z.min g g') (x + y)).
    { apply multiple_add; [apply multiple_le with g | apply multiple_le with g']; try assumption; lia. }
    apply RN_within; [exact H1 | exact M | now apply multiple_at_least, multiple_RN | now apply at_most_add].
Qed.

Lemma within_opp s x : within s x -> within s (- x).
Proof.
  destruct s; simpl; [intros ->; ring|]. intros (A & B & C). split; [now apply multiple_opp|].
  split; [|now rewrite Rabs_Ropp]. destruct B as [-> | B]; [left; ring | right; now rewrite Rabs_Ropp].
Qed.

Lemma integer_within z : within (of_integer z) (IZR z).
Proof.
  assert (Positive : forall p, within (Between (twos p) (twos p) (Z.log2_up (Zpos p))) (IZR (Zpos p))).
  { intros p. assert (M : multiple (twos p) (IZR (Zpos p))).
    { induction p as [p _ | p IH |]; simpl twos.
      1, 3: rewrite multiple_integer; eexists; change (power 0) with 1; symmetry; apply Rmult_1_r.
      rewrite multiple_integer in *. destruct IH as (n & E). exists n. unfold power in *. rewrite bpow_plus_1.
      change (Zpos p~0) with (2 * Zpos p)%Z. rewrite mult_IZR, E. simpl (IZR radix2). ring. }
    split; [exact M|]. split; [now apply multiple_at_least|].
    rewrite Rabs_right by (apply Rle_ge, IZR_le; lia). unfold power. rewrite <- IZR_Zpower by apply Z.log2_up_nonneg.
    apply IZR_le. destruct (Pos.eq_dec p 1) as [-> | N]; [simpl; lia|]. apply Z.log2_up_spec. lia. }
  destruct z as [|p|p]; [reflexivity | apply Positive |]. simpl of_integer.
  change (Zneg p) with (- Zpos p)%Z. rewrite opp_IZR. apply within_opp, Positive.
Qed.

(** A small number without digits below those of floats is a float. *)
Lemma multiple_normal g v : (-1074 <= g)%Z -> multiple g v -> normal_or_float v.
Proof.
  intros H M. destruct (Rle_or_lt smallest_normal (Rabs v)) as [N | N]; [now right | left].
  destruct (Req_dec v 0) as [-> | Z]; [apply float_0|]. revert M. apply generic_inclusion_mag. intros _.
  assert (mag radix2 v <= -1022)%Z by now apply mag_le_bpow. unfold exponent, FLT_exp, FIX_exp. lia.
Qed.

Lemma normal_at_least l v : (-1022 <= l)%Z -> at_least l v -> normal_or_float v.
Proof.
  intros H [-> | V]; [left; apply float_0 | right]. apply Rle_trans with (2 := V). now apply power_le.
Qed.

Lemma product_within s a b x y :
  of_product a b = Some s -> within a x -> within b y -> within s (RN (x * y)) /\ normal_or_float (x * y).
Proof.
  intros H A B. destruct a as [|g l h]; [simpl in A; subst x|destruct b as [|g' l' h']; [simpl in B; subst y|]].
  1, 2: injection H as <-; rewrite ?Rmult_0_l, ?Rmult_0_r; (split; [apply RN_float, float_0 | left; apply float_0]).
  simpl in H. destruct (_ || _)%bool eqn:L in H; [|discriminate].
  apply limited_true in H as (-> & H1). destruct A as (A1 & A2 & A3), B as (B1 & B2 & B3).
  assert (P := at_least_mul _ _ _ _ A2 B2). assert (G : multiple (g + g') (x * y)) by now apply multiple_mul.
  assert (Least : (-1074 <= l + l')%Z) by lia. assert (R := RN_at_least (l + l') _ Least P).
  split; [split; [|split; [exact R | now apply RN_at_most, at_most_mul]]|].
  - destruct (Z.max_spec (g + g') (l + l' - 52)) as [[_ ->] | [_ ->]]; [|now apply multiple_RN].
    apply float_multiple; [apply float_RN | exact R].
  - destruct (Z.le_gt_cases (-1022) (l + l')) as [N | N]; [now apply normal_at_least with (l + l')%Z|].
    apply multiple_normal with (g + g')%Z; [lia | exact G].
Qed.

Lemma quotient_within s a b x y :
  of_quotient a b = Some s -> within a x -> within b y -> within s (RN (x / y)) /\ normal_or_float (x / y).
Proof.
  intros H A B. destruct b as [|g' l' h']; [destruct a; discriminate|]. destruct (Req_dec y 0) as [-> | N].
  { assert (E : x / 0 = 0) by (unfold Rdiv; rewrite Rinv_0; ring). rewrite E, RN_float by apply float_0.
    split; [|left; apply float_0]. destruct s; [reflexivity|]. split; [apply generic_format_0|]. split; [now left|].
    rewrite Rabs_R0. apply bpow_ge_0. }
  destruct a as [|g l h]; [simpl in A; subst x|].
  { injection H as <-. unfold Rdiv. rewrite Rmult_0_l. split; [apply RN_float, float_0 | left; apply float_0]. }
  simpl in H. destruct (Z.leb_spec (-1022) (l - h')) as [L | _]; [|discriminate].
  apply limited_true in H as (-> & H1). destruct A as (A1 & A2 & A3), B as (_ & B2 & B3).
  destruct (within_inv _ _ _ N B2 B3) as (I1 & I2).
  assert (P := at_least_mul _ _ _ _ A2 (or_intror I1)). change (l + - h')%Z with (l - h')%Z in P.
  split; [|now apply normal_at_least with (l - h')%Z].
  assert (R := RN_at_least (l - h') _ ltac:(lia) P).
  split; [apply float_multiple; [apply float_RN | exact R] | split; [exact R|]].
  apply RN_at_most; [exact H1|]. now apply at_most_mul.
Qed.

Lemma product_error_within s a b x y :
  of_product_error a b = Some s -> within a x -> within b y ->
  within s (RN (x * y - RN (x * y))) /\ (x * y = 0 \/ smallest_exact_product <= Rabs (x * y)).
Proof.
  intros H A B. destruct a as [|g l h]; [simpl in A; subst x|destruct b as [|g' l' h']; [simpl in B; subst y|]].
  1, 2: injection H as <-; rewrite ?Rmult_0_l, ?Rmult_0_r, (RN_float 0) by apply float_0; simpl;
    rewrite Rminus_0_r; (split; [apply RN_float, float_0 | now left]).
  simpl in H. destruct (Z.leb_spec (-969) (l + l')) as [L | _]; [|discriminate].
  apply limited_true in H as (-> & H1). destruct A as (A1 & A2 & A3), B as (B1 & B2 & B3).
  assert (P := at_least_mul _ _ _ _ A2 B2). split.
  - assert (M : multiple (g + g') (x * y - RN (x * y))).
    { apply multiple_add; [|apply multiple_opp, multiple_RN]; now apply multiple_mul. }
    apply RN_within; [exact H1 | exact M | now apply multiple_at_least, multiple_RN |].
    assert (N : normal_or_float (x * y)) by (apply normal_at_least with (l + l')%Z; [lia | exact P]).
    assert (E := rounds_error _ _ (rounds_normal _ N)). rewrite Rabs_minus_sym. apply Rle_trans with (1 := E).
    replace (h + h' - 53)%Z with (-53 + (h + h'))%Z by ring. unfold power. rewrite bpow_plus. fold power. fold u.
    apply Rmult_le_compat_l; [apply bpow_ge_0 | now apply at_most_mul].
  - destruct P as [P | P]; [now left | right]. apply Rle_trans with (2 := P). now apply power_le.
Qed.

Hypothesis constant_float : forall i z, PositiveMap.find i operations = Some (Constant z) -> is_float (IZR z).

Lemma found_sound known i o s :
  (forall j t, PositiveMap.find j known = Some t -> within t (f j)) -> PositiveMap.find i operations = Some o ->
  found known o = Some s -> within s (f i) /\ regular f o.
Proof.
  intros K O H. assert (V := f_value _ _ O).
  assert (Two : forall step a b, both step (PositiveMap.find a known) (PositiveMap.find b known) = Some s ->
    exists x y, step x y = Some s /\ within x (f a) /\ within y (f b)).
  { intros step a b E. destruct (PositiveMap.find a known) as [x|] eqn:A; [|discriminate].
    destruct (PositiveMap.find b known) as [y|] eqn:B; [|discriminate]. exists x, y. auto. }
  destruct o; simpl in H, V; simpl regular; rewrite V.
  - apply limited_true in H as (-> & _). split; [|exact I]. rewrite RN_float by apply input_float.
    destruct (input_range k0) as [-> | (E1 & E2)].
    + split; [apply generic_format_0|]. split; [now left|]. rewrite Rabs_R0. apply bpow_ge_0.
    + assert (L : at_least (- k) (input k0)) by now right. split; [now apply float_multiple | now split].
  - injection H as <-. split; [|exact I]. rewrite RN_float by now apply (constant_float i). apply integer_within.
  - split; [|exact I]. rewrite RN_opp, RN_float by apply f_float. now apply within_opp, K.
  - destruct (Two _ _ _ H) as (x & y & E & X & Y). split; [|exact I]. now apply sum_within with x y.
  - destruct (Two _ _ _ H) as (x & y & E & X & Y). split; [|exact I]. now apply sum_within with x y.
  - destruct (Two _ _ _ H) as (x & y & E & X & Y). split; [|exact I]. unfold Rminus.
    apply sum_within with x y; try assumption; [apply f_float | apply float_opp, f_float | now apply within_opp].
  - destruct (Two _ _ _ H) as (x & y & E & X & Y). now apply product_within with x y.
  - destruct (Two _ _ _ H) as (x & y & E & X & Y). now apply quotient_within with x y.
  - destruct (multiplies operations p a b) eqn:M; [|discriminate]. destruct (Two _ _ _ H) as (x & y & E & X & Y).
    assert (P : f p = RN (f a * f b)).
    { unfold multiplies, operation_of in M. destruct (PositiveMap.find p operations) as [[]|] eqn:Q; try discriminate.
      assert (W := f_value _ _ Q). simpl in W. apply pair_test in M as [[-> ->] | [-> ->]]; [exact W|].
      now rewrite W, Rmult_comm. }
    rewrite P. now apply product_error_within with x y.
Qed.

Lemma fits_sound p : forall known,
  (forall j t, PositiveMap.find j known = Some t -> within t (f j)) ->
  (forall i o, In (i, o) p -> PositiveMap.find i operations = Some o) ->
  fits known p = true -> Forall (fun named => small (f (fst named)) /\ regular f (snd named)) p.
Proof.
  induction p as [|[i o] p IH]; intros known K P H; [constructor|]. simpl in H.
  destruct (found known o) as [s|] eqn:E; [|discriminate]. apply andb_prop in H as [H1 H2].
  destruct (found_sound known i o s K (P _ _ (or_introl eq_refl)) E) as (W & G).
  constructor; [split; [now apply within_small with s | exact G]|].
  apply (IH _) in H2; [exact H2 | | intros j q Q; apply P; now right].
  intros j t T. apply find_add in T as [[-> ->] | T]; auto.
Qed.

End Following.
