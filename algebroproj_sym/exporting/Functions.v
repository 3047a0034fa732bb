(** Roots, angles, exponentials and logarithms: what is true of them, law by law.

A law speaks of values by names, [v = exp u], so that what a proof does with them is about polynomials. *)

From Coq Require Import Reals Lra Psatz Machin Ranalysis_reg.
Open Scope R_scope.

(** ** Functions that the library does not have *)

Definition root (n : nat) (u : R) : R :=
  if Req_EM_T u 0 then 0 else Rpower u (/ INR n).

Definition sign (u : R) : R :=
  if Rlt_dec 0 u then 1 else if Rlt_dec u 0 then -1 else 0.

Definition atan2 (y x : R) : R :=
  if Rlt_dec y 0 then - acos (x / sqrt (x * x + y * y)) else acos (x / sqrt (x * x + y * y)).

(** ** Relations to zero *)

Lemma zero_from t k p m : t = 0 -> t * k = p * m -> m <> 0 -> p = 0.
Proof. intros; subst; rewrite Rmult_0_l in *; destruct (Rmult_integral p m); congruence. Qed.

Lemma nonzero_from t k p m : t <> 0 -> t * k = p * m -> k <> 0 -> p <> 0.
Proof. intros T E K P; subst; rewrite Rmult_0_l in E; destruct (Rmult_integral t k); auto. Qed.

Lemma positive_from t k p m : 0 < t -> t * k = p * m -> 0 < k -> 0 < m -> 0 < p.
Proof. intros; apply Rmult_lt_reg_r with m; nra. Qed.

Lemma nonnegative_from t k p m : 0 <= t -> t * k = p * m -> 0 < k -> 0 < m -> 0 <= p.
Proof. intros; apply Rmult_le_reg_r with m; nra. Qed.

Lemma positive_nonzero p : 0 < p -> p <> 0.
Proof. lra. Qed.

Lemma opposite_nonzero p q : 0 < q -> p = - q -> p <> 0.
Proof. lra. Qed.

Lemma zero_nonnegative p : p = 0 -> 0 <= p.
Proof. lra. Qed.

Lemma positive_nonnegative p : 0 < p -> 0 <= p.
Proof. lra. Qed.

Lemma both_positive p : 0 <= p -> p <> 0 -> 0 < p.
Proof. lra. Qed.

Lemma both_zero p : 0 <= p -> 0 <= - p -> p = 0.
Proof. lra. Qed.

Lemma equal_difference a b : a = b -> a - b = 0.
Proof. lra. Qed.

Lemma unequal_difference a b : a <> b -> a - b <> 0.
Proof. lra. Qed.

Lemma less_difference a b : b < a -> 0 < a - b.
Proof. lra. Qed.

Lemma at_most_difference a b : b <= a -> 0 <= a - b.
Proof. lra. Qed.

Lemma difference_equal a b : a - b = 0 -> a = b.
Proof. lra. Qed.

Lemma difference_unequal a b : a - b <> 0 -> a <> b.
Proof. lra. Qed.

Lemma difference_less a b : 0 < a - b -> b < a.
Proof. lra. Qed.

Lemma difference_at_most a b : 0 <= a - b -> b <= a.
Proof. lra. Qed.

(** ** Sums and products of what is known *)

Lemma sum_zero a b : a = 0 -> b = 0 -> a + b = 0.
Proof. lra. Qed.

Lemma multiple_zero c p : p = 0 -> c * p = 0.
Proof. intros; subst; ring. Qed.

Lemma product_nonzero a b : a <> 0 -> b <> 0 -> a * b <> 0.
Proof. intros; apply Rmult_integral_contrapositive_currified; assumption. Qed.

Lemma product_positive a b : 0 < a -> 0 < b -> 0 < a * b.
Proof. apply Rmult_lt_0_compat. Qed.

Lemma product_nonnegative a b : 0 <= a -> 0 <= b -> 0 <= a * b.
Proof. apply Rmult_le_pos. Qed.

Lemma power_nonzero p n : p <> 0 -> p ^ n <> 0.
Proof. apply pow_nonzero. Qed.

Lemma power_positive p n : 0 < p -> 0 < p ^ n.
Proof. apply pow_lt. Qed.

Lemma power_nonnegative p n : 0 <= p -> 0 <= p ^ n.
Proof. apply pow_le. Qed.

Lemma square_positive p : p <> 0 -> 0 < p * p.
Proof. nra. Qed.

Lemma factor_nonzero p f q : p <> 0 -> p = f * q -> f <> 0.
Proof. intros P E F; subst; apply P; ring. Qed.

Lemma weighted_nonnegative w r p : 0 < w -> 0 <= p -> 0 <= w * (r * r) * p.
Proof. intros; apply Rmult_le_pos; nra. Qed.

Lemma weighted_positive w r p : 0 < w -> r <> 0 -> 0 < p -> 0 < w * (r * r) * p.
Proof.
  intros; assert (0 < r * r) by nra.
  apply product_positive; [apply product_positive|]; assumption.
Qed.

Lemma sum_nonnegative a b : 0 <= a -> 0 <= b -> 0 <= a + b.
Proof. lra. Qed.

Lemma sum_positive_left a b : 0 < a -> 0 <= b -> 0 < a + b.
Proof. lra. Qed.

Lemma sum_positive_right a b : 0 <= a -> 0 < b -> 0 < a + b.
Proof. lra. Qed.

(** ** Conclusions from combinations *)

Lemma zero_by w p n z : w <> 0 -> z = 0 -> w * p ^ n = z -> p = 0.
Proof.
  intros W Z E; rewrite Z in E.
  destruct (Req_dec p 0) as [|P]; [assumption|].
  now destruct (product_nonzero w (p ^ n) W (power_nonzero p n P)).
Qed.

Lemma absurd_by w z : w <> 0 -> z = 0 -> w = z -> 1 = 0.
Proof. intros; now subst. Qed.

Lemma positive_by w p z s : 0 < w -> z = 0 -> 0 < s -> w * p = z + s -> 0 < p.
Proof. intros; apply Rmult_lt_reg_l with w; lra. Qed.

Lemma nonnegative_by w p z s : 0 < w -> z = 0 -> 0 <= s -> w * p = z + s -> 0 <= p.
Proof. intros; apply Rmult_le_reg_l with w; lra. Qed.

Lemma nonzero_by_factor w f p z : w <> 0 -> z = 0 -> w = f * p + z -> p <> 0.
Proof. intros W Z E P; subst; apply W; ring. Qed.

(** ** Cases *)

Lemma three_cases p : 0 < p \/ p = 0 \/ 0 < - p.
Proof. destruct (Rtotal_order 0 p) as [|[|]]; lra. Qed.

Lemma not_negative_or_negative p : 0 <= p \/ 0 < - p.
Proof. destruct (Rle_dec 0 p); lra. Qed.

(** ** The number pi *)

Lemma facts_of_pi : 0 < PI - 3 /\ 0 < 22 - 7 * PI.
Proof.
  split; [pose proof PI2_3_2; lra|].
  destruct (PI_2_3_7_ineq 1) as [_ bound].
  unfold tg_alt, PI_2_3_7_tg, Ratan_seq in bound; simpl in bound; lra.
Qed.

(** ** What holds for each function wherever it is defined *)

Lemma facts_of_sqrt r u : r = sqrt u -> 0 <= u -> 0 <= r /\ r ^ 2 - u = 0.
Proof.
  intros -> U; split; [apply sqrt_pos|].
  rewrite <- (sqrt_sqrt u U) at 2; ring.
Qed.

Lemma strictly_of_sqrt r u : r = sqrt u -> 0 < u -> 0 < r /\ r ^ 2 - u = 0.
Proof.
  intros E U; destruct (facts_of_sqrt r u E) as [_ square]; [lra|].
  split; [subst; now apply sqrt_lt_R0 | assumption].
Qed.

Lemma strictly_of_root n r u : r = root (S n) u -> 0 < u -> 0 < r /\ r ^ S n - u = 0.
Proof.
  unfold root; intros -> U; destruct (Req_EM_T u 0); [lra|].
  split; [apply exp_pos|].
  rewrite <- Rpower_pow by apply exp_pos.
  rewrite Rpower_mult, Rinv_l by (apply not_0_INR; discriminate).
  rewrite Rpower_1 by assumption; ring.
Qed.

Lemma facts_of_root n r u : r = root (S n) u -> 0 <= u -> 0 <= r /\ r ^ S n - u = 0.
Proof.
  intros E [U|U].
  - destruct (strictly_of_root n r u E U); split; lra.
  - unfold root in E; subst u; destruct (Req_EM_T 0 0); [|contradiction].
    rewrite E, pow_i by lia; lra.
Qed.

Lemma facts_of_sin s c u : s = sin u -> c = cos u -> s * s + c * c - 1 = 0.
Proof. intros -> ->; pose proof (sin2_cos2 u); unfold Rsqr in *; lra. Qed.

Lemma facts_of_exp v u : v = exp u -> 0 < v /\ 0 <= v - 1 - u /\ 0 <= 1 - v * (1 - u).
Proof.
  intros ->; pose proof (exp_pos u); pose proof (exp_ineq1_le u).
  repeat split; try lra.
  pose proof (exp_ineq1_le (- u)).
  assert (exp u * exp (- u) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
  nra.
Qed.

Lemma strict_bounds_of_exp v u : v = exp u -> u <> 0 -> 0 < v - 1 - u /\ 0 < 1 - v * (1 - u).
Proof.
  intros -> U; pose proof (exp_pos u); pose proof (exp_ineq1 u U); split; [lra|].
  pose proof (exp_ineq1 (- u) ltac:(lra)).
  assert (exp u * exp (- u) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
  nra.
Qed.

Lemma facts_of_log v u : v = ln u -> 0 < u -> 0 <= u - 1 - v /\ 0 <= u * v - u + 1.
Proof.
  intros -> U; destruct (facts_of_exp u (ln u)) as [_ [low high]]; [now rewrite exp_ln|].
  split; lra.
Qed.

Lemma strict_bounds_of_log v u : v = ln u -> 0 < u -> u - 1 <> 0 -> 0 < u - 1 - v /\ 0 < u * v - u + 1.
Proof.
  intros -> U one.
  destruct (strict_bounds_of_exp u (ln u)) as [low high]; [now rewrite exp_ln| |split; lra].
  intros zero; apply one; rewrite <- (exp_ln u U), zero, exp_0; ring.
Qed.

Lemma facts_of_sign s u : s = sign u -> s ^ 3 - s = 0 /\ u * (s * s - 1) = 0 /\ 0 <= u * s.
Proof.
  unfold sign; intros ->.
  destruct (Rlt_dec 0 u); [|destruct (Rlt_dec u 0)]; repeat split; nra.
Qed.

Lemma sign_of_positive s u : s = sign u -> 0 < u -> s - 1 = 0.
Proof. unfold sign; intros -> U; destruct (Rlt_dec 0 u); lra. Qed.

Lemma sign_of_negative s u : s = sign u -> 0 < - u -> s - - (1) = 0.
Proof. unfold sign; intros -> U; destruct (Rlt_dec 0 u), (Rlt_dec u 0); lra. Qed.

Lemma sign_of_zero s u : s = sign u -> u = 0 -> s - 0 = 0.
Proof. unfold sign; intros -> U; destruct (Rlt_dec 0 u), (Rlt_dec u 0); lra. Qed.

Lemma facts_of_asin a s c u : a = asin u -> s = sin a -> c = cos a -> 0 <= 1 - u * u ->
  s - u = 0 /\ 0 <= c /\ 0 <= PI - 2 * a /\ 0 <= PI + 2 * a.
Proof.
  intros -> -> -> U; assert (-1 <= u <= 1) by nra.
  pose proof (asin_bound u); rewrite sin_asin by assumption.
  pose proof (cos_ge_0 (asin u)); repeat split; lra.
Qed.

Lemma facts_of_atan a s c u : a = atan u -> s = sin a -> c = cos a ->
  s - u * c = 0 /\ 0 < c /\ 0 < PI - 2 * a /\ 0 < PI + 2 * a.
Proof.
  intros -> -> ->; pose proof (atan_bound u).
  pose proof (cos_gt_0 (atan u)); pose proof (tan_atan u) as E; unfold tan in E.
  repeat split; try lra.
  replace (sin (atan u)) with (sin (atan u) / cos (atan u) * cos (atan u)) by (field; lra).
  rewrite E; ring.
Qed.

Lemma on_circle r c s x y : 0 < r -> r * c = x -> y = r * s -> c * c + s * s = 1 ->
  y * c - x * s = 0 /\ 0 < x * c + y * s /\ (x * c + y * s) ^ 2 - x * x - y * y = 0.
Proof.
  intros R <- -> one.
  replace (r * c * c + r * s * s) with (r * (c * c + s * s)) by ring; rewrite one.
  repeat split; [ring | lra |].
  replace ((r * 1) ^ 2 - r * c * (r * c) - r * s * (r * s)) with (r * r - r * r * (c * c + s * s)) by ring.
  rewrite one; ring.
Qed.

Lemma facts_of_atan2 a s c y x : a = atan2 y x -> s = sin a -> c = cos a -> y * y + x * x <> 0 ->
  y * c - x * s = 0 /\ 0 < x * c + y * s /\ (x * c + y * s) ^ 2 - x * x - y * y = 0 /\ 0 <= PI - a /\ 0 < PI + a.
Proof.
  intros A -> -> U.
  assert (0 < x * x + y * y) as positive by nra.
  set (r := sqrt (x * x + y * y)).
  assert (0 < r) by now apply sqrt_lt_R0.
  assert (r * r = x * x + y * y) by (apply sqrt_sqrt; lra).
  assert (r * (x / r) = x) as quotient by (field; lra).
  assert (-1 <= x / r <= 1) as range by (split; apply Rmult_le_reg_l with r; nra).
  pose proof (acos_bound (x / r)).
  pose proof (cos_acos (x / r) range) as cosine.
  pose proof (sin_acos (x / r) range) as sine.
  assert (0 <= 1 - x / r * (x / r)) as rest by nra.
  pose proof (sqrt_pos (1 - Rsqr (x / r))) as up.
  assert (sqrt (1 - Rsqr (x / r)) * sqrt (1 - Rsqr (x / r)) = 1 - x / r * (x / r)) as square
    by (apply sqrt_sqrt; exact rest).
  set (h := sqrt (1 - Rsqr (x / r))) in *; set (q := x / r) in *.
  assert (r * h * (r * h) = y * y).
  { replace (r * h * (r * h)) with (r * r * (h * h)) by ring; rewrite square.
    replace (r * r * (1 - q * q)) with (r * r - r * q * (r * q)) by ring; rewrite quotient; lra. }
  unfold atan2 in A; fold r in A; fold q in A; destruct (Rlt_dec y 0) as [below|above]; subst a.
  - assert (y = r * - h) as height by (assert (0 <= r * h) by nra; nra).
    rewrite cos_neg, sin_neg, cosine, sine.
    assert (acos q <> PI) by (intros E; rewrite E, cos_PI in cosine; nra).
    destruct (on_circle r q (- h) x y) as [? []]; [nra.. | repeat split; lra].
  - assert (y = r * h) as height by (assert (0 <= r * h) by nra; nra).
    rewrite cosine, sine; pose proof PI_RGT_0.
    destruct (on_circle r q h x y) as [? []]; [nra.. | repeat split; lra].
Qed.

(** ** Functions that are defined by others *)

Lemma absolute u : Rabs u = sqrt (u ^ 2).
Proof. rewrite <- sqrt_Rsqr_abs; unfold Rsqr; f_equal; ring. Qed.

Lemma arc_cosine u : 0 <= 1 - u ^ 2 -> acos u = PI / 2 - asin u.
Proof. intros; apply acos_asin; nra. Qed.

Lemma hyperbolic_sine u : sinh u = (exp u + - (1 / exp u)) / 2.
Proof. unfold sinh; rewrite exp_Ropp; field; pose proof (exp_pos u); lra. Qed.

Lemma hyperbolic_cosine u : cosh u = (exp u + 1 / exp u) / 2.
Proof. unfold cosh; rewrite exp_Ropp; field; pose proof (exp_pos u); lra. Qed.

Lemma hyperbolic_tangent u : tanh u = (exp u + - (1 / exp u)) / (exp u + 1 / exp u).
Proof.
  unfold tanh; rewrite hyperbolic_sine, hyperbolic_cosine; pose proof (exp_pos u); field; split; nra.
Qed.

Lemma area_radicand u : 0 <= u ^ 2 + 1.
Proof. nra. Qed.

Lemma area_argument u : 0 < u + sqrt (u ^ 2 + 1).
Proof.
  pose proof (sqrt_pos (u ^ 2 + 1)); pose proof (sqrt_sqrt (u ^ 2 + 1) (area_radicand u)); nra.
Qed.

(** ** Angles *)

Definition turned (a c s : R) : Prop := cos a = c /\ sin a = s.

Lemma unturned : turned 0 1 0.
Proof. split; [apply cos_0 | apply sin_0]. Qed.

Lemma once c s t : c = cos t -> s = sin t -> turned t c s.
Proof. split; congruence. Qed.

Lemma reversed a c s : turned a c s -> turned (- a) c (- s).
Proof. intros [<- <-]; split; [apply cos_neg | apply sin_neg]. Qed.

Lemma twice a c s : turned a c s -> turned (2 * a) (c * c - s * s) (2 * (s * c)).
Proof. intros [<- <-]; split; [apply cos_2a | rewrite sin_2a; ring]. Qed.

Lemma together a c s b c' s' : turned a c s -> turned b c' s' -> turned (a + b) (c * c' - s * s') (c * s' + s * c').
Proof. intros [<- <-] [<- <-]; split; rewrite ?cos_plus, ?sin_plus; ring. Qed.

Lemma quarter_cosine t : 2 * t = PI -> 0 = cos t.
Proof. intros; replace t with (PI / 2) by lra; now rewrite cos_PI2. Qed.

Lemma quarter_sine t : 2 * t = PI -> 1 = sin t.
Proof. intros; replace t with (PI / 2) by lra; now rewrite sin_PI2. Qed.

Lemma addition A S C a c s : S = sin A -> C = cos A -> turned a c s -> A - a = 0 -> S - s = 0 /\ C - c = 0.
Proof. intros -> -> [<- <-] E; replace A with a by lra; lra. Qed.

Lemma zero_of_sine F s : s = sin F -> s = 0 -> 0 < PI - F -> 0 < PI + F -> F = 0.
Proof.
  intros -> zero below above; destruct (Rtotal_order F 0) as [less|[|more]]; [|assumption|].
  - pose proof (sin_gt_0 (- F)); rewrite sin_neg in *; lra.
  - pose proof (sin_gt_0 F); lra.
Qed.

Lemma full_turn F c : c = cos F -> c - 1 = 0 -> 0 < 2 * PI - F -> 0 < 2 * PI + F -> F = 0.
Proof.
  intros -> one below above.
  assert (sin (F / 2) = 0) as half.
  { replace F with (2 * (F / 2)) in one by field; rewrite cos_2a_sin in one; nra. }
  pose proof (zero_of_sine (F / 2) (sin (F / 2)) eq_refl half); lra.
Qed.

Lemma sine_in_range F s : s = sin F -> 0 <= F -> 0 <= PI - F -> 0 <= s.
Proof. intros ->; intros; apply sin_ge_0; lra. Qed.

Lemma sine_strictly_in_range F s : s = sin F -> 0 < F -> 0 < PI - F -> 0 < s.
Proof. intros ->; intros; apply sin_gt_0; lra. Qed.

Lemma cosine_in_range F c : c = cos F -> 0 <= PI - 2 * F -> 0 <= PI + 2 * F -> 0 <= c.
Proof. intros ->; intros; apply cos_ge_0; lra. Qed.

Lemma cosine_strictly_in_range F c : c = cos F -> 0 < PI - 2 * F -> 0 < PI + 2 * F -> 0 < c.
Proof. intros ->; intros; apply cos_gt_0; lra. Qed.

Lemma range_of_sine F s : s = sin F -> 0 < s -> 0 <= F + PI -> 0 <= 2 * PI - F -> 0 < F /\ 0 < PI - F.
Proof.
  intros -> positive low high; split.
  - destruct (Rlt_dec 0 F); [assumption|].
    pose proof (sin_ge_0 (- F)); rewrite sin_neg in *; lra.
  - destruct (Rlt_dec 0 (PI - F)); [assumption|].
    pose proof (sin_ge_0 (F - PI)) as shifted.
    rewrite sin_minus, cos_PI, sin_PI in shifted; lra.
Qed.

Lemma range_of_cosine F c : c = cos F -> 0 < c -> 0 <= 3 * PI - 2 * F -> 0 <= 3 * PI + 2 * F ->
  0 < PI - 2 * F /\ 0 < PI + 2 * F.
Proof.
  intros -> positive high low.
  destruct (range_of_sine (F + PI / 2) (cos F)); try lra.
  rewrite sin_plus, cos_PI2, sin_PI2; ring.
Qed.

Lemma range_of_sine_weakly F s : s = sin F -> 0 <= s -> 0 < F + PI -> 0 < 2 * PI - F -> 0 <= F /\ 0 <= PI - F.
Proof.
  intros -> positive low high; split.
  - destruct (Rle_dec 0 F); [assumption|].
    pose proof (sin_gt_0 (- F)); rewrite sin_neg in *; lra.
  - destruct (Rle_dec 0 (PI - F)); [assumption|].
    pose proof (sin_gt_0 (F - PI)) as shifted.
    rewrite sin_minus, cos_PI, sin_PI in shifted; lra.
Qed.

Lemma range_of_cosine_weakly F c : c = cos F -> 0 <= c -> 0 < 3 * PI - 2 * F -> 0 < 3 * PI + 2 * F ->
  0 <= PI - 2 * F /\ 0 <= PI + 2 * F.
Proof.
  intros -> positive high low.
  destruct (range_of_sine_weakly (F + PI / 2) (cos F)); try lra.
  rewrite sin_plus, cos_PI2, sin_PI2; ring.
Qed.

Lemma order_of_sines A a B b : a = sin A -> b = sin B -> 0 <= PI - 2 * A -> 0 <= PI + 2 * A ->
  0 <= PI - 2 * B -> 0 <= PI + 2 * B -> 0 <= a - b -> 0 <= A - B.
Proof. intros -> ->; intros; pose proof (sin_incr_0 B A); lra. Qed.

Lemma order_of_sines_strictly A a B b : a = sin A -> b = sin B -> 0 <= PI - 2 * A -> 0 <= PI + 2 * A ->
  0 <= PI - 2 * B -> 0 <= PI + 2 * B -> 0 < a - b -> 0 < A - B.
Proof. intros -> ->; intros; pose proof (sin_increasing_0 B A); lra. Qed.

Lemma equal_sines A a B b : a = sin A -> b = sin B -> 0 <= PI - 2 * A -> 0 <= PI + 2 * A ->
  0 <= PI - 2 * B -> 0 <= PI + 2 * B -> a - b = 0 -> A - B = 0.
Proof. intros -> ->; intros; pose proof (sin_incr_0 B A); pose proof (sin_incr_0 A B); lra. Qed.

(** ** Exponentials, logarithms and powers *)

Lemma no_exponent : exp 0 * 1 = 1.
Proof. rewrite exp_0; ring. Qed.

Lemma exponent_on a p q u w : exp a * q = p -> w = exp u -> exp (a + u) * q = p * w.
Proof. intros <- ->; rewrite exp_plus; ring. Qed.

Lemma exponent_back a p q u w : exp a * q = p -> w = exp u -> exp (a - u) * (q * w) = p.
Proof.
  intros <- ->; unfold Rminus; rewrite exp_plus, exp_Ropp; field; pose proof (exp_pos u); lra.
Qed.

Lemma exp_of_log l p : l = ln p -> 0 < p -> p = exp l.
Proof. intros ->; intros; now rewrite exp_ln. Qed.

Lemma exponents A E a p q : E = exp A -> exp a * q = p -> A - a = 0 -> E * q - p = 0.
Proof. intros -> <- zero; replace A with a by lra; ring. Qed.

Lemma no_factor : 0 < 1 /\ ln 1 = 0.
Proof. split; [lra | apply ln_1]. Qed.

Lemma factor_on a v p l : 0 < a /\ ln a = v -> 0 < p -> l = ln p -> 0 < a * p /\ ln (a * p) = v + l.
Proof. intros [] P ->; subst; rewrite ln_mult by assumption; split; [nra | reflexivity]. Qed.

Lemma factor_back a v p l : 0 < a /\ ln a = v -> 0 < p -> l = ln p -> 0 < a / p /\ ln (a / p) = v - l.
Proof.
  intros [] P ->; subst; pose proof (Rinv_0_lt_compat p P); unfold Rdiv; rewrite ln_mult, ln_Rinv by assumption.
  split; [nra | reflexivity].
Qed.

Lemma log_of_exp p u : p = exp u -> u = ln p.
Proof. intros ->; now rewrite ln_exp. Qed.

Lemma logarithms A L a v : L = ln A -> 0 < a /\ ln a = v -> A - a = 0 -> L - v = 0.
Proof. intros -> [_ <-] zero; replace A with a by lra; ring. Qed.

Lemma increasing_power n x y : 0 <= x < y -> x ^ S n < y ^ S n.
Proof.
  intros [X Y]; induction n as [|n IH]; [lra|].
  change (x * x ^ S n < y * y ^ S n); pose proof (pow_le x (S n) X); nra.
Qed.

Lemma order_of_powers a b n : 0 <= a -> 0 <= a ^ S n - b ^ S n -> 0 <= a - b.
Proof. intros A D; destruct (Rle_dec b a); [lra|]; pose proof (increasing_power n a b); lra. Qed.

Lemma order_of_powers_strictly a b n : 0 <= a -> 0 < a ^ S n - b ^ S n -> 0 < a - b.
Proof. intros A D; destruct (Rlt_dec b a); [lra|]; pose proof (pow_incr a b (S n)); lra. Qed.

Lemma equal_powers a b n : 0 <= a -> 0 <= b -> a ^ S n - b ^ S n = 0 -> a - b = 0.
Proof.
  intros A B E; destruct (Rtotal_order a b) as [less|[|more]]; [| lra |].
  - pose proof (increasing_power n a b); lra.
  - pose proof (increasing_power n b a); lra.
Qed.

(** ** Enclosures of numbers *)

Lemma close_to_pi : 3141592 / 1000000 <= PI <= 3141593 / 1000000.
Proof.
  destruct (PI_2_3_7_ineq 3) as [low high].
  unfold tg_alt, PI_2_3_7_tg, Ratan_seq in low, high; simpl in low, high; lra.
Qed.

Lemma product_between a b c d x y l h : a <= x <= b -> c <= y <= d ->
  l <= a * c -> l <= a * d -> l <= b * c -> l <= b * d ->
  a * c <= h -> a * d <= h -> b * c <= h -> b * d <= h -> l <= x * y <= h.
Proof.
  intros [X1 X2] [Y1 Y2] ? ? ? ? ? ? ? ?.
  assert (A : a * c <= a * y <= a * d \/ a * d <= a * y <= a * c)
    by (destruct (Rle_lt_dec 0 a); [left | right]; split; nra).
  assert (B : b * c <= b * y <= b * d \/ b * d <= b * y <= b * c)
    by (destruct (Rle_lt_dec 0 b); [left | right]; split; nra).
  assert (X : a * y <= x * y <= b * y \/ b * y <= x * y <= a * y)
    by (destruct (Rle_lt_dec 0 y); [left | right]; split; nra).
  lra.
Qed.

Lemma root_between r a n l h : 0 <= r -> r ^ S n - a = 0 -> 0 <= l -> 0 <= h ->
  l ^ S n <= a -> a <= h ^ S n -> l <= r <= h.
Proof.
  intros R0 E L H A B.
  split; apply Rnot_lt_le; intros lt.
  - assert (M := pow_incr r l (S n) (conj R0 (Rlt_le _ _ lt))).
    assert (D : l ^ S n - r ^ S n = 0) by lra. pose proof (equal_powers l r n L R0 D); lra.
  - assert (M := pow_incr h r (S n) (conj H (Rlt_le _ _ lt))).
    assert (D : r ^ S n - h ^ S n = 0) by lra. pose proof (equal_powers r h n R0 H D); lra.
Qed.

Definition sine_below a := a - a ^ 3 / 6 + a ^ 5 / 120 - a ^ 7 / 5040.
Definition sine_above a := sine_below a + a ^ 9 / 362880.
Definition cosine_below a := 1 - a ^ 2 / 2 + a ^ 4 / 24 - a ^ 6 / 720.
Definition cosine_above a := cosine_below a + a ^ 8 / 40320.

Lemma factorial n z : Z.of_nat (fact n) = z -> INR (fact n) = IZR z.
Proof. intros <-; apply INR_IZR_INZ. Qed.

Lemma sine_of u : 0 <= u <= 3 / 2 -> sine_below u <= sin u <= sine_above u.
Proof.
  intros U. pose proof close_to_pi. destruct (sin_bound u 1 ltac:(lra) ltac:(lra)) as [low high].
  unfold sine_above, sine_below, sin_approx, sin_term in *.
  cbn [sum_f_R0 Nat.mul Nat.add] in low, high.
  rewrite (factorial 1 1), (factorial 3 6), (factorial 5 120), (factorial 7 5040) in low, high by reflexivity.
  rewrite (factorial 9 362880) in high by (vm_compute; reflexivity).
  split; [apply Rle_trans with (2 := low) | apply Rle_trans with (1 := high)]; apply Req_le; field.
Qed.

Lemma cosine_of u : 0 <= u <= 3 / 2 -> cosine_below u <= cos u <= cosine_above u.
Proof.
  intros U. pose proof close_to_pi. destruct (cos_bound u 1 ltac:(lra) ltac:(lra)) as [low high].
  unfold cosine_above, cosine_below, cos_approx, cos_term in *.
  cbn [sum_f_R0 Nat.mul Nat.add] in low, high.
  rewrite (factorial 0 1), (factorial 2 2), (factorial 4 24), (factorial 6 720) in low, high by reflexivity.
  rewrite (factorial 8 40320) in high by (vm_compute; reflexivity).
  split; [apply Rle_trans with (2 := low) | apply Rle_trans with (1 := high)]; apply Req_le; field.
Qed.

Lemma sine_between s u l h : s = sin u -> 0 <= l -> l <= u <= h -> h <= 3 / 2 ->
  sine_below l <= s <= sine_above h.
Proof.
  intros -> L U H. pose proof close_to_pi.
  pose proof (sine_of l ltac:(lra)). pose proof (sine_of h ltac:(lra)).
  pose proof (sin_incr_1 l u ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
  pose proof (sin_incr_1 u h ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.

Lemma cosine_between c u l h : c = cos u -> 0 <= l -> l <= u <= h -> h <= 3 / 2 ->
  cosine_below h <= c <= cosine_above l.
Proof.
  intros -> L U H. pose proof close_to_pi.
  pose proof (cosine_of l ltac:(lra)). pose proof (cosine_of h ltac:(lra)).
  pose proof (cos_decr_1 l u ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
  pose proof (cos_decr_1 u h ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.

Lemma arc_sine_between a u l h : a = asin u -> 0 <= u <= 1 -> 0 <= l <= 3 / 2 -> 0 <= h <= 3 / 2 ->
  sine_above l <= u -> u <= sine_below h -> l <= a <= h.
Proof.
  intros -> U L H A B. pose proof close_to_pi. pose proof (asin_bound u) as R.
  pose proof (sin_asin u ltac:(lra)) as S.
  pose proof (sine_of l L). pose proof (sine_of h H).
  split; apply Rnot_lt_le; intros lt.
  - pose proof (sin_increasing_1 (asin u) l ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) lt); lra.
  - pose proof (sin_increasing_1 h (asin u) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) lt); lra.
Qed.

Lemma arc_tangent_between a u l h : a = atan u -> 0 <= u -> 0 <= l <= 3 / 2 -> 0 <= h <= 3 / 2 ->
  sine_above l <= u * cosine_below l -> u * cosine_above h <= sine_below h -> l <= a <= h.
Proof.
  intros -> U L H A B. pose proof close_to_pi. destruct (atan_bound u) as [low high].
  destruct (sine_of l L), (sine_of h H), (cosine_of l L), (cosine_of h H).
  assert (C : forall t, - (PI / 2) < t < PI / 2 -> 0 < cos t) by (intros; apply cos_gt_0; lra).
  assert (T : forall t, 0 < cos t -> tan t * cos t = sin t) by (intros; unfold tan; field; lra).
  pose proof (C l ltac:(lra)) as Cl. pose proof (C h ltac:(lra)) as Ch.
  pose proof (T l Cl). pose proof (T h Ch).
  assert (tan l <= u) by (apply Rmult_le_reg_r with (cos l); nra).
  assert (u <= tan h) by (apply Rmult_le_reg_r with (cos h); nra).
  assert (M : forall x y, x <= y -> atan x <= atan y)
    by (intros x y [lt | ->]; [left; now apply atan_increasing | right; reflexivity]).
  split; [rewrite <- (atan_tan l) by lra | rewrite <- (atan_tan h) by lra]; now apply M.
Qed.

(** ** Tactics: two quotients are equal, and a product is not zero *)

Ltac nonzero :=
  match goal with
  | |- _ /\ _ => split; nonzero
  | |- _ * _ <> 0 => apply product_nonzero; nonzero
  | |- _ ^ _ <> 0 => apply power_nonzero; nonzero
  | |- IZR _ <> 0 => apply not_0_IZR; discriminate
  | |- _ => first
    [ assumption
    | lra
    | match goal with known : ?p <> 0 |- ?q <> 0 => intros zero; apply known; rewrite <- zero; ring end
    | match goal with known : ?p <> 0 |- ?q <> 0 => intros zero; apply known; first [lra | rewrite zero; ring] end ]
  end.

Ltac matching := first [ring | field; nonzero].

Ltac positive :=
  match goal with
  | |- 0 < ?p * ?p => apply square_positive; nonzero
  | |- 0 < _ * _ => apply product_positive; positive
  | |- 0 < IZR _ => now apply IZR_lt
  | |- _ => lra
  end.

Ltac evident := first [lra | nra | intros zero; nra].
