(** Rounding of binary64, and the coefficients of error bounds. *)

From Coq Require Import Reals ZArith NArith Lia Lra.
From Flocq Require Import Core Relative Plus_error Mult_error.
From Flocq.Pff Require Import Pff2Flocq.

Open Scope R_scope.

(** ** Numbers of 53 digits, rounded to nearest even *)

Definition exponent := FLT_exp (-1074) 53.
Definition RN := round radix2 exponent ZnearestE.
Definition is_float := generic_format radix2 exponent.

Definition u := bpow radix2 (-53).
Definition smallest_normal := bpow radix2 (-1022).
Definition smallest_exact_product := bpow radix2 (-969).

Lemma u_bounds : 0 < u <= 1 / 1024.
Proof. unfold u; simpl; lra. Qed.

Lemma u_value : u = / 9007199254740992.
Proof. reflexivity. Qed.

Lemma u_ro_is_u : u_ro radix2 53 = u.
Proof. unfold u_ro, u; simpl; lra. Qed.

#[global] Instance precision_positive : Prec_gt_0 53.
Proof. reflexivity. Qed.

Lemma float_RN x : is_float (RN x).
Proof. apply generic_format_round; typeclasses eauto. Qed.

Lemma RN_float x : is_float x -> RN x = x.
Proof. apply round_generic; typeclasses eauto. Qed.

Lemma float_0 : is_float 0.
Proof. apply generic_format_0. Qed.

Lemma float_opp x : is_float x -> is_float (- x).
Proof. apply generic_format_opp. Qed.

(** What rounding takes from a number: at most [u] times the number, and the result is a factor near 1 times it. *)
Definition rounds (x r : R) := exists d, Rabs d <= u / (1 + u) /\ r = x * (1 + d).

Lemma half_unit : u / (1 + u) <= u.
Proof.
  assert (H := u_bounds). apply Rmult_le_reg_r with (1 + u); [lra|].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra.
Qed.

Lemma rounds_error x r : rounds x r -> Rabs (r - x) <= u * Rabs x.
Proof.
  intros (d & Hd & ->). replace (x * (1 + d) - x) with (d * x) by ring.
  rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|]. assert (H := half_unit). lra.
Qed.

Lemma rounds_sum x y : is_float x -> is_float y -> rounds (x + y) (RN (x + y)).
Proof.
  intros Hx Hy. destruct (FLT_plus_error_N_ex radix2 (-1074) 53 (fun z => negb (Z.even z)) x y Hx Hy) as (d & Hd & E).
  exists d. rewrite u_ro_is_u in Hd. split; [exact Hd | exact E].
Qed.

Lemma rounds_difference x y : is_float x -> is_float y -> rounds (x - y) (RN (x - y)).
Proof. intros Hx Hy. apply rounds_sum; [|apply float_opp]; assumption. Qed.

Definition normal_or_float x := is_float x \/ smallest_normal <= Rabs x.

Lemma rounds_normal x : normal_or_float x -> rounds x (RN x).
Proof.
  intros [F | H].
  - exists 0. rewrite Rabs_R0. split.
    + assert (Hu := u_bounds). apply Rmult_le_pos; [lra|]. apply Rlt_le, Rinv_0_lt_compat. lra.
    + rewrite RN_float by exact F. ring.
  - destruct (relative_error_N_FLX'_ex radix2 53 eq_refl (fun z => negb (Z.even z)) x) as (d' & Hd' & E').
    rewrite u_ro_is_u in Hd'. exists d'. split; [exact Hd'|]. unfold RN. rewrite <- E'.
    apply round_FLT_FLX. exact H.
Qed.

Lemma exact_product_error x y :
  is_float x -> is_float y -> x * y = 0 \/ smallest_exact_product <= Rabs (x * y) ->
  RN (x * y - RN (x * y)) = x * y - RN (x * y).
Proof.
  intros Hx Hy H. apply RN_float. replace (x * y - RN (x * y)) with (- (RN (x * y) - x * y)) by ring.
  apply float_opp, mult_error_FLT; try typeclasses eauto; try assumption.
  intros Hn. destruct H as [H | H]; [contradiction | exact H].
Qed.

Lemma symmetric_choice x : negb (Z.even x) = negb (negb (Z.even (- (x + 1)))).
Proof. rewrite Z.even_opp, Z.even_add. now destruct (Z.even x). Qed.

(** Knuth's error of a sum, in the order of operations of the C source. *)
Lemma sum_error a b :
  is_float a -> is_float b ->
  let t := RN (a + b) in
  let s := RN (t - a) in
  RN (RN (a - RN (t - s)) + RN (b - s)) = a + b - t.
Proof.
  intros Ha Hb t s.
  assert (H := TwoSum_correct (-1074) 53 (fun z => negb (Z.even z)) eq_refl ltac:(lia) symmetric_choice a b Ha Hb).
  unfold s, t, RN in *. unfold exponent in *. lra.
Qed.

Lemma RN_opp x : RN (- x) = - RN x.
Proof. apply round_NE_opp. Qed.

Lemma difference_error a b :
  is_float a -> is_float b ->
  let t := RN (a - b) in
  let s := RN (t - a) in
  RN (RN (a - RN (t - s)) - RN (b + s)) = a - b - t.
Proof.
  intros Ha Hb t s. assert (H := sum_error a (- b) Ha (float_opp _ Hb)). cbv zeta in H.
  change (a + - b) with (a - b) in H. fold t in H. fold s in H.
  replace (- b - s) with (- (b + s)) in H by ring. rewrite RN_opp in H. unfold Rminus at 1. exact H.
Qed.

(** The same error from products of halves, which are exact (Dekker), in the order of operations of the C source. *)
Definition splitter := 134217729.
Definition upper_half x := RN (RN (splitter * x) - RN (RN (splitter * x) - x)).
Definition lower_half x := RN (x - upper_half x).

Lemma split_product_error a b :
  is_float a -> is_float b -> a * b = 0 \/ smallest_exact_product <= Rabs (a * b) ->
  let p := RN (a * b) in
  RN (RN (RN (RN (RN (upper_half a * upper_half b) - p) + RN (upper_half a * lower_half b))
    + RN (lower_half a * upper_half b)) + RN (lower_half a * lower_half b)) = a * b - p.
Proof.
  intros Ha Hb H p.
  assert (D := proj1 (Dekker radix2 (-1074) 53 (fun z => negb (Z.even z)) ltac:(lia) ltac:(lia) a b Ha Hb
    (or_introl eq_refl)) H).
  fold exponent in D. change (Znearest (fun z : Z => negb (Z.even z))) with ZnearestE in D. fold RN in D.
  replace (bpow radix2 (53 - Z.div2 53) + 1) with splitter in D by (unfold splitter; simpl; lra).
  assert (E : forall x, RN (RN (x - RN (x * splitter)) + RN (x * splitter)) = upper_half x).
  { intros x. unfold upper_half. rewrite (Rmult_comm splitter x).
    replace (RN (x * splitter) - x) with (- (x - RN (x * splitter))) by ring. rewrite RN_opp. f_equal. ring. }
  change (round radix2 exponent ZnearestE) with RN in D.
  rewrite !E in D. unfold lower_half. unfold p.
  replace (RN (upper_half a * upper_half b) - RN (a * b)) with (- RN (a * b) + RN (upper_half a * upper_half b)) by ring.
  lra.
Qed.

(** ** Coefficients: multiples of 2^-20, rounded upwards *)

Definition one : N := 1048576.
Definition c (n : N) : R := IZR (Z.of_N n) / 1048576.
Definition upwards (a k : N) : N := N.shiftr (a + (2 ^ k - 1)) k.
Definition times (a b : N) : N := upwards (a * b) 20.
Definition tiny (a : N) : N := upwards a 53.
Definition bump (a : N) : N := (a + tiny a)%N.

Lemma c_pos n : 0 <= c n.
Proof. unfold c. assert (0 <= IZR (Z.of_N n)) by (apply IZR_le; lia). lra. Qed.

Lemma c_le a b : (a <= b)%N -> c a <= c b.
Proof. intros H. unfold c. assert (IZR (Z.of_N a) <= IZR (Z.of_N b)) by (apply IZR_le; lia). lra. Qed.

Lemma c_value n : c n = IZR (Z.of_N n) / 1048576.
Proof. reflexivity. Qed.

Lemma c_0 : c 0 = 0.
Proof. unfold c; simpl; lra. Qed.

Lemma c_one : c one = 1.
Proof. unfold c, one; simpl; lra. Qed.

Lemma c_whole n : c (n * one) = IZR (Z.of_N n).
Proof. unfold c, one. rewrite N2Z.inj_mul, mult_IZR. simpl (IZR (Z.of_N 1048576)). lra. Qed.

Lemma c_add a b : c (a + b) = c a + c b.
Proof. unfold c. rewrite N2Z.inj_add, plus_IZR. lra. Qed.

Lemma upwards_le a k : (a <= upwards a k * 2 ^ k)%N.
Proof.
  unfold upwards. rewrite N.shiftr_div_pow2. assert (H : (2 ^ k <> 0)%N) by (apply N.pow_nonzero; lia).
  assert (D := N.div_mod (a + (2 ^ k - 1)) (2 ^ k) H). assert (M := N.mod_lt (a + (2 ^ k - 1)) (2 ^ k) H). lia.
Qed.

Lemma c_times a b : c a * c b <= c (times a b).
Proof.
  unfold times, c. assert (H := upwards_le (a * b) 20).
  assert (G : IZR (Z.of_N (a * b)) <= IZR (Z.of_N (upwards (a * b) 20 * 2 ^ 20))) by (apply IZR_le; lia).
  rewrite !N2Z.inj_mul, !mult_IZR in G. change (Z.of_N (2 ^ 20)) with 1048576%Z in G. lra.
Qed.

Lemma c_tiny a : c a * u <= c (tiny a).
Proof.
  unfold tiny, c. assert (H := upwards_le a 53).
  assert (G : IZR (Z.of_N a) <= IZR (Z.of_N (upwards a 53 * 2 ^ 53))) by (apply IZR_le; lia).
  rewrite N2Z.inj_mul, mult_IZR in G. change (Z.of_N (2 ^ 53)) with 9007199254740992%Z in G.
  rewrite u_value. lra.
Qed.

Lemma c_bump a : c a * (1 + u) <= c (bump a).
Proof. unfold bump. rewrite c_add. assert (H := c_tiny a). lra. Qed.

Lemma c_bump_ge a : c a <= c (bump a).
Proof. unfold bump. rewrite c_add. assert (H := c_pos (tiny a)). lra. Qed.

#[global] Opaque c times tiny bump one.

(** ** Factors near 1 *)

Definition factor (t p : R) := 1 - t <= p /\ p * (1 - t) <= 1.

Lemma factor_1 : factor 0 1.
Proof. split; lra. Qed.

Lemma factor_le s t p : 0 <= s -> s <= t -> t < 1 -> factor s p -> factor t p.
Proof.
  intros H0 H1 H2 (Ha & Hb). split; [lra|]. apply Rle_trans with (p * (1 - s)); [|lra].
  apply Rmult_le_compat_l; lra.
Qed.

Lemma factor_mul s t p q : 0 <= s -> 0 <= t -> s + t < 1 -> factor s p -> factor t q -> factor (s + t) (p * q).
Proof.
  intros Hs Ht H (Pa & Pb) (Qa & Qb). split.
  - apply Rle_trans with ((1 - s) * (1 - t)); [nra|]. apply Rmult_le_compat; lra.
  - apply Rle_trans with ((p * (1 - s)) * (q * (1 - t))).
    + replace (p * (1 - s) * (q * (1 - t))) with (p * q * ((1 - s) * (1 - t))) by ring.
      apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | nra].
    + replace 1 with (1 * 1) by ring. apply Rmult_le_compat; try lra; apply Rmult_le_pos; lra.
Qed.

Lemma factor_pos t p : t < 1 -> factor t p -> 0 < p.
Proof. intros H (A & _). lra. Qed.

Lemma factor_inv t p : t < 1 -> factor t p -> factor t (/ p).
Proof.
  intros H F. assert (P := factor_pos t p H F). destruct F as (A & B). split.
  - apply Rmult_le_reg_r with p; [exact P|]. rewrite Rinv_l by lra. lra.
  - apply Rmult_le_reg_l with p; [exact P|]. rewrite <- Rmult_assoc, Rinv_r by lra. lra.
Qed.

Lemma factor_near t d : 0 <= t -> t < 1 -> Rabs d <= t -> factor t (1 + d).
Proof.
  intros H L D. apply Rabs_le_inv in D. split; [lra|].
  apply Rle_trans with ((1 + t) * (1 - t)); [|nra]. apply Rmult_le_compat_r; lra.
Qed.

Lemma factor_rounds x r : rounds x r -> exists p, r = x * p /\ factor u p.
Proof.
  intros (d & Hd & ->). exists (1 + d). split; [reflexivity|]. assert (H := u_bounds). apply factor_near; [lra | lra |].
  assert (G := half_unit). lra.
Qed.

Lemma factor_bound t p : t < 1 -> factor t p -> Rabs (p - 1) <= t / (1 - t).
Proof.
  intros H (A & B). apply Rabs_le.
  assert (I : t / (1 - t) * (1 - t) = t) by (field; lra). split.
  - assert (t <= t / (1 - t) \/ t < 0) as [T | T].
    { destruct (Rlt_le_dec t 0) as [L | L]; [right; exact L | left].
      apply Rmult_le_reg_r with (1 - t); [lra|]. rewrite I. nra. }
    + lra.
    + exfalso. assert (1 - t <= 1) by (apply Rle_trans with (p * (1 - t)); nra). lra.
  - apply Rmult_le_reg_r with (1 - t); [lra|]. rewrite I. lra.
Qed.

(** The mean of two numbers of one sign, each times a factor, is their sum times such a factor. *)
Lemma factor_mean t x y p q :
  0 <= t -> t < 1 -> 0 <= x -> 0 <= y -> factor t p -> factor t q ->
  exists r, x * p + y * q = (x + y) * r /\ factor t r.
Proof.
  intros H0 H1 Hx Hy (Pa & Pb) (Qa & Qb).
  destruct (Req_dec (x + y) 0) as [E | E].
  - exists 1. split; [|split; nra]. assert (x = 0) by lra. assert (y = 0) by lra. subst. ring.
  - exists ((x * p + y * q) / (x + y)). split; [field; exact E|]. split.
    + apply Rmult_le_reg_r with (x + y); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by exact E. nra.
    + apply Rmult_le_reg_r with (x + y); [lra|]. unfold Rdiv.
      replace ((x * p + y * q) * / (x + y) * (1 - t) * (x + y)) with (x * (p * (1 - t)) + y * (q * (1 - t)))
        by (field; exact E). nra.
Qed.
