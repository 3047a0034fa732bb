(** Numbers that are kept as an unevaluated sum of two, and bounds of their error. *)

From Coq Require Import Reals ZArith NArith Lia Lra.
From Flocq Require Import Core.
From Algebroproj Require Import Rounding.

Open Scope R_scope.

(** An error of the size of [u^2], and a low part of the size of [u], each relative to a magnitude [m]. *)
Definition near (e : N) (m d : R) := Rabs d <= c e * (u * u) * m.
Definition low (l : N) (m d : R) := Rabs d <= c l * u * m.

(** The size of a first part. *)
Definition head (l e : N) : N := (one + (tiny l + tiny e))%N.

Ltac positive_u := assert (u_lo := proj1 u_bounds); assert (u_hi := proj2 u_bounds).

Lemma scale a b k : a <= b -> 0 <= k -> a * k <= b * k.
Proof. intros H K. apply Rmult_le_compat_r; assumption. Qed.

Lemma near_le e e' m d : (e <= e')%N -> 0 <= m -> near e m d -> near e' m d.
Proof.
  intros H M D. unfold near in *. apply Rle_trans with (1 := D). positive_u.
  apply scale; [|exact M]. apply scale; [now apply c_le | nra].
Qed.

Lemma low_le l l' m d : (l <= l')%N -> 0 <= m -> low l m d -> low l' m d.
Proof.
  intros H M D. unfold low in *. apply Rle_trans with (1 := D). positive_u.
  apply scale; [|exact M]. apply scale; [now apply c_le | lra].
Qed.

Lemma near_0 e m : 0 <= m -> near e m 0.
Proof.
  intros M. unfold near. rewrite Rabs_R0. positive_u. assert (H := c_pos e).
  apply Rmult_le_pos; [apply Rmult_le_pos; nra | exact M].
Qed.

Lemma low_0 l m : 0 <= m -> low l m 0.
Proof.
  intros M. unfold low. rewrite Rabs_R0. positive_u. assert (H := c_pos l).
  apply Rmult_le_pos; [apply Rmult_le_pos; lra | exact M].
Qed.

Lemma near_opp e m d : near e m d -> near e m (- d).
Proof. unfold near. now rewrite Rabs_Ropp. Qed.

Lemma low_opp l m d : low l m d -> low l m (- d).
Proof. unfold low. now rewrite Rabs_Ropp. Qed.

Lemma near_add a b m x y : near a m x -> near b m y -> near (a + b) m (x + y).
Proof.
  unfold near. intros X Y. apply Rle_trans with (1 := Rabs_triang x y). rewrite c_add. lra.
Qed.

Lemma low_add a b m x y : low a m x -> low b m y -> low (a + b) m (x + y).
Proof.
  unfold low. intros X Y. apply Rle_trans with (1 := Rabs_triang x y). rewrite c_add. lra.
Qed.

(** Sums of numbers with different magnitudes. *)
Lemma near_sum a b m n x y : 0 <= m -> 0 <= n -> near a m x -> near b n y -> near (N.max a b) (m + n) (x + y).
Proof.
  intros M N X Y. apply (near_le _ (N.max a b)) in X, Y; try assumption; try lia.
  unfold near in *. apply Rle_trans with (1 := Rabs_triang x y). lra.
Qed.

Lemma low_sum a b m n x y : 0 <= m -> 0 <= n -> low a m x -> low b n y -> low (N.max a b) (m + n) (x + y).
Proof.
  intros M N X Y. apply (low_le _ (N.max a b)) in X, Y; try assumption; try lia.
  unfold low in *. apply Rle_trans with (1 := Rabs_triang x y). lra.
Qed.

(** What is rounded off a low part is an error. *)
Lemma low_rounded l m x r : 0 <= m -> low l m x -> rounds x r -> near l m (r - x) /\ low (bump l) m r.
Proof.
  intros M L H. assert (E := rounds_error _ _ H). positive_u. unfold low, near in *. split.
  - apply Rle_trans with (1 := E). apply Rle_trans with (u * (c l * u * m)); [|right; ring].
    apply Rmult_le_compat_l; lra.
  - replace r with (x + (r - x)) by ring. apply Rle_trans with (1 := Rabs_triang _ _).
    apply Rle_trans with (c l * (1 + u) * u * m).
    + apply Rle_trans with ((1 + u) * (c l * u * m)); [|right; ring].
      apply Rle_trans with ((1 + u) * Rabs x); [lra|]. apply Rmult_le_compat_l; lra.
    + apply scale; [|exact M]. apply scale; [apply c_bump | lra].
Qed.

Lemma tiny_low l m : 0 <= m -> c l * u * m <= c (tiny l) * m.
Proof. intros M. apply scale; [apply c_tiny | exact M]. Qed.

Lemma tiny_near e m : 0 <= m -> c e * (u * u) * m <= c (tiny e) * m.
Proof.
  intros M. apply scale; [|exact M]. positive_u. apply Rle_trans with (c e * u); [|apply c_tiny].
  assert (H := c_pos e). apply Rmult_le_compat_l; [exact H | nra].
Qed.

Lemma near_low e m d : 0 <= m -> near e m d -> low (tiny e) m d.
Proof.
  intros M D. apply Rle_trans with (1 := D). apply scale; [|exact M]. positive_u. rewrite <- Rmult_assoc.
  apply scale; [apply c_tiny | lra].
Qed.

Lemma near_wide e m n d : m <= n -> near e m d -> near e n d.
Proof.
  intros M D. apply Rle_trans with (1 := D). assert (H := c_pos e). positive_u.
  apply Rmult_le_compat_l; [apply Rmult_le_pos; nra | exact M].
Qed.

Lemma low_wide l m n d : m <= n -> low l m d -> low l n d.
Proof.
  intros M D. apply Rle_trans with (1 := D). assert (H := c_pos l). positive_u.
  apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact M].
Qed.

Lemma head_bound l e m s r x : 0 <= m -> Rabs x <= m -> low l m r -> near e m (s + r - x) -> Rabs s <= c (head l e) * m.
Proof.
  intros M X L D. replace s with (x + (- r + (s + r - x))) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _). assert (T := Rabs_triang (- r) (s + r - x)). rewrite Rabs_Ropp in T.
  unfold head. rewrite !c_add, c_one. assert (A := tiny_low l m M). assert (B := tiny_near e m M).
  unfold low, near in *. lra.
Qed.

(** *** The low part of a sum or product that is a rounded number [h] and what rounding took from it *)

Lemma error_low k m s h : Rabs s <= c k * m -> rounds s h -> low k m (s - h).
Proof.
  intros S H. assert (E := rounds_error _ _ H). positive_u. unfold low.
  replace (s - h) with (- (h - s)) by ring. rewrite Rabs_Ropp. apply Rle_trans with (1 := E).
  apply Rle_trans with (u * (c k * m)); [apply Rmult_le_compat_l; lra | right; ring].
Qed.

(** With a rest [r], rounded once more. *)
Lemma with_rest k l e m s h r x t :
  0 <= m -> Rabs s <= c k * m -> rounds s h -> low l m r -> near e m (s + r - x) -> rounds (r + (s - h)) t ->
  near (e + (l + k)) m (h + t - x) /\ low (bump (l + k)) m t.
Proof.
  intros M S H L D T.
  assert (Y := low_add _ _ _ _ _ L (error_low _ _ _ _ S H)).
  destruct (low_rounded _ _ _ _ M Y T) as (A & B). split; [|exact B].
  replace (h + t - x) with ((s + r - x) + (t - (r + (s - h)))) by ring. now apply near_add.
Qed.

(** ** Products *)

Lemma abs_mul x y a b k m n : Rabs x <= a * m -> Rabs y <= b * n -> a * b <= k -> 0 <= m -> 0 <= n -> Rabs (x * y) <= k * (m * n).
Proof.
  intros X Y K M N. rewrite Rabs_mult.
  apply Rle_trans with (a * m * (b * n)).
  - apply Rmult_le_compat; try apply Rabs_pos; assumption.
  - replace (a * m * (b * n)) with (a * b * (m * n)) by ring. apply scale; [exact K | nra].
Qed.

Lemma head_times a b m n x y : 0 <= m -> 0 <= n -> Rabs x <= c a * m -> Rabs y <= c b * n -> Rabs (x * y) <= c (times a b) * (m * n).
Proof. intros M N X Y. now apply (abs_mul x y (c a) (c b)); [| | apply c_times | |]. Qed.

Lemma head_low a b m n x y : 0 <= m -> 0 <= n -> Rabs x <= c a * m -> low b n y -> low (times a b) (m * n) (x * y).
Proof.
  intros M N X Y. unfold low in *. apply (abs_mul x y (c a) (c b * u)); try assumption.
  rewrite <- Rmult_assoc. positive_u. apply scale; [apply c_times | lra].
Qed.

Lemma low_head a b m n x y : 0 <= m -> 0 <= n -> low a m x -> Rabs y <= c b * n -> low (times a b) (m * n) (x * y).
Proof.
  intros M N X Y. unfold low in *. apply (abs_mul x y (c a * u) (c b)); try assumption.
  replace (c a * u * c b) with (c a * c b * u) by ring. positive_u. apply scale; [apply c_times | lra].
Qed.

Lemma low_low a b m n x y : 0 <= m -> 0 <= n -> low a m x -> low b n y -> near (times a b) (m * n) (x * y).
Proof.
  intros M N X Y. unfold low, near in *. apply (abs_mul x y (c a * u) (c b * u)); try assumption.
  replace (c a * u * (c b * u)) with (c a * c b * (u * u)) by ring. positive_u. apply scale; [apply c_times | nra].
Qed.

Definition product_error (a b : N) : N := (a + b + tiny (times a b))%N.

(** The error of the product of two sums. *)
Lemma exact_product a b m n p q x y :
  Rabs x <= m -> Rabs y <= n -> near a m (p - x) -> near b n (q - y) ->
  near (product_error a b) (m * n) (p * q - x * y).
Proof.
  intros X Y A B. assert (M : 0 <= m) by (assert (H := Rabs_pos x); lra).
  assert (N : 0 <= n) by (assert (H := Rabs_pos y); lra). unfold product_error.
  replace (p * q - x * y) with ((p - x) * y + x * (q - y) + (p - x) * (q - y)) by ring.
  positive_u. apply near_add; [apply near_add|].
  - unfold near in *. apply (abs_mul _ _ (c a * (u * u)) 1); try assumption; lra.
  - unfold near in *. apply (abs_mul _ _ 1 (c b * (u * u))); try assumption; lra.
  - unfold near in *. apply (abs_mul _ _ (c a * (u * u)) (c b * (u * u))); try assumption.
    replace (c a * (u * u) * (c b * (u * u))) with (c a * c b * u * u * (u * u)) by ring.
    apply scale; [|nra]. apply Rle_trans with (c (times a b) * u * u).
    + apply scale; [|lra]. apply scale; [apply c_times | lra].
    + apply Rle_trans with (c (tiny (times a b)) * 1); [|lra].
      assert (T := c_tiny (times a b)). assert (P := c_pos (times a b)). apply Rmult_le_compat; try lra; nra.
Qed.

(** ** Rounding a pair *)

Lemma product_ratio e m x d : x <> 0 -> near e m d -> Rabs (d / x) <= c e * (u * u) * Rabs (m / x).
Proof.
  intros X D. unfold Rdiv. rewrite !Rabs_mult, <- Rmult_assoc. apply scale; [|apply Rabs_pos].
  unfold near in D. apply Rle_trans with (1 := D). apply Rmult_le_compat_l; [|apply RRle_abs].
  positive_u. assert (H := c_pos e). nra.
Qed.

(** The error of a pair that is small enough is a factor. *)
Lemma pair_factor e m x s :
  (e <> 0%N -> x <> 0) -> near e m (s - x) -> c e * (u * u) * Rabs (m / x) < 1 ->
  exists p, s = x * p /\ factor (c e * (u * u) * Rabs (m / x)) p.
Proof.
  intros X D T. positive_u. assert (P := c_pos e).
  assert (K : 0 <= c e * (u * u) * Rabs (m / x)) by (apply Rmult_le_pos; [nra | apply Rabs_pos]).
  destruct (N.eq_dec e 0) as [-> | E].
  - exists 1. unfold near in D. rewrite c_0 in *. split.
    + assert (Rabs (s - x) = 0) by (assert (H := Rabs_pos (s - x)); lra).
      apply Rabs_eq_R0 in H. lra.
    + apply (factor_le 0); try lra. apply factor_1.
  - exists (1 + (s - x) / x). split; [field; auto|]. apply factor_near; try assumption.
    apply product_ratio; auto.
Qed.

(** A sum rounded without what rounding took from its first part. *)
Lemma rest_factor l e m x s h r :
  ((bump e + l)%N <> 0%N -> x <> 0) -> rounds s h -> low l m r -> near e m (s + r - x) ->
  u + c (bump e + l) * (u * u) * Rabs (m / x) < 1 ->
  exists p, h + r = x * p /\ factor (u + c (bump e + l) * (u * u) * Rabs (m / x)) p.
Proof.
  intros X (d & Hd & ->) L D T. positive_u. assert (P := c_pos (bump e + l)).
  assert (Dd : Rabs d <= u) by (assert (H := half_unit); lra).
  destruct (N.eq_dec (bump e + l) 0) as [Z | Z].
  - assert (c e = 0) by (assert (A := c_bump_ge e); assert (B := c_pos e);
      assert (bump e = 0%N) by lia; rewrite H, c_0 in A; lra).
    assert (c l = 0) by (assert (l = 0%N) by lia; subst l; apply c_0).
    unfold near, low in *. rewrite H in D. rewrite H0 in L. rewrite Z, c_0 in *.
    assert (Rabs r = 0) by (assert (G := Rabs_pos r); lra). apply Rabs_eq_R0 in H1. subst r.
    assert (Rabs (s + 0 - x) = 0) by (assert (G := Rabs_pos (s + 0 - x)); lra). apply Rabs_eq_R0 in H1.
    exists (1 + d). split; [replace s with x by lra; ring|]. apply factor_near; lra.
  - specialize (X Z). exists (1 + (d + (s + r - x) / x * (1 + d) - r / x * d)). split; [field; exact X|].
    apply factor_near; try assumption.
    { assert (0 <= Rabs (m / x)) by apply Rabs_pos. assert (0 <= c (bump e + l) * (u * u)) by nra. nra. }
    assert (A : Rabs ((s + r - x) / x * (1 + d)) <= c (bump e) * (u * u) * Rabs (m / x)).
    { rewrite Rabs_mult. apply product_ratio with (1 := X) in D.
      assert (Rabs (1 + d) <= 1 + u) by (apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_R1; lra).
      apply Rle_trans with (c e * (u * u) * Rabs (m / x) * (1 + u)).
      - apply Rmult_le_compat; try apply Rabs_pos; assumption.
      - replace (c e * (u * u) * Rabs (m / x) * (1 + u)) with (c e * (1 + u) * (u * u) * Rabs (m / x)) by ring.
        apply scale; [|apply Rabs_pos]. apply scale; [apply c_bump | nra]. }
    assert (B : Rabs (r / x * d) <= c l * (u * u) * Rabs (m / x)).
    { rewrite Rabs_mult. unfold Rdiv. rewrite !Rabs_mult. unfold low in L.
      replace (c l * (u * u) * (Rabs m * Rabs (/ x))) with (c l * u * Rabs m * Rabs (/ x) * u) by ring.
      apply Rmult_le_compat; try apply Rabs_pos; [apply Rmult_le_pos; apply Rabs_pos | | exact Dd].
      apply scale; [|apply Rabs_pos]. apply Rle_trans with (1 := L). apply Rmult_le_compat_l; [|apply RRle_abs].
      assert (H := c_pos l). nra. }
    rewrite c_add. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp.
    assert (C := Rabs_triang d ((s + r - x) / x * (1 + d))). lra.
Qed.

(** ** Parts that are separated: rounded to one number, and what rounding took from it *)

(** The size of the new second part, and the error with the fast way, which need not be exact. *)
Definition separated_rest (l e : N) : N :=
  let h := (one + tiny e)%N in bump (h + tiny (l + h)).
Definition separated_error (l e : N) : N :=
  let h := (one + tiny e)%N in (e + (l + h) + (h + tiny (l + h)))%N.

Lemma whole_bound e m s x : 0 <= m -> Rabs x <= m -> near e m (s - x) -> Rabs s <= c (one + tiny e) * m.
Proof.
  intros M X D. replace s with (x + (s - x)) by ring. apply Rle_trans with (1 := Rabs_triang _ _).
  rewrite c_add, c_one. assert (B := tiny_near e m M). unfold near in D. lra.
Qed.

Lemma separated_fast l e m a b x s v t :
  0 <= m -> Rabs x <= m -> near e m (a + b - x) -> low l m b ->
  rounds (a + b) s -> rounds (s - a) v -> rounds (b - v) t ->
  near (separated_error l e) m (s + t - x) /\ low (separated_rest l e) m t.
Proof.
  intros M X D L S V T. unfold separated_error, separated_rest. set (h := (one + tiny e)%N).
  assert (W := error_low h m _ _ (whole_bound e m _ x M X D) S).
  assert (Lv : low (l + h) m (s - a)).
  { replace (s - a) with (b + - (a + b - s)) by ring. apply low_add; [exact L | now apply low_opp]. }
  destruct (low_rounded _ _ _ _ M Lv V) as (Nv & _).
  assert (Lt : low (h + tiny (l + h)) m (b - v)).
  { replace (b - v) with ((a + b - s) + - (v - (s - a))) by ring. apply low_add; [exact W|].
    now apply low_opp, near_low. }
  destruct (low_rounded _ _ _ _ M Lt T) as (Nt & Rt). split; [|exact Rt].
  replace (s + t - x) with ((a + b - x) + - (v - (s - a)) + (t - (b - v))) by ring.
  apply near_add; [apply near_add; [exact D | now apply near_opp] | exact Nt].
Qed.

(** With the error of the sum, which is exact. *)
Lemma separated_exact e m a b x s t :
  0 <= m -> Rabs x <= m -> near e m (a + b - x) -> rounds (a + b) s -> t = a + b - s ->
  near e m (s + t - x) /\ low (one + tiny e) m t.
Proof.
  intros M X D S ->. split; [now replace (s + (a + b - s) - x) with (a + b - x) by ring|].
  apply error_low; [now apply whole_bound with x | exact S].
Qed.

(** ** Quotients *)

(** More than the third power of the inverse of a factor that is within 2^-10 of 1. *)
Definition slack : N := 1052672.

Lemma c_slack : c slack = 1 + 1 / 256.
Proof. rewrite c_value. unfold slack. simpl. lra. Qed.

Lemma near_over e n b y v : 0 <= n -> Rabs (/ b) <= c slack * / Rabs y -> y <> 0 -> near e n v -> near (times slack e) (n / Rabs y) (v / b).
Proof.
  intros N B Y D. unfold near in *. assert (P := Rinv_0_lt_compat _ (Rabs_pos_lt _ Y)). assert (C := c_times slack e).
  apply (abs_mul v (/ b) (c e * (u * u)) (c slack)); try assumption; try lra. positive_u.
  replace (c e * (u * u) * c slack) with (c slack * c e * (u * u)) by ring. apply scale; [exact C | nra].
Qed.

Lemma low_over l n b y v : 0 <= n -> Rabs (/ b) <= c slack * / Rabs y -> y <> 0 -> low l n v -> low (times slack l) (n / Rabs y) (v / b).
Proof.
  intros N B Y D. unfold low in *. assert (P := Rinv_0_lt_compat _ (Rabs_pos_lt _ Y)). assert (C := c_times slack l).
  apply (abs_mul v (/ b) (c l * u) (c slack)); try assumption; try lra. positive_u.
  replace (c l * u * c slack) with (c slack * c l * u) by ring. apply scale; [exact C | lra].
Qed.

(** The steps of a division: the quotient of the first parts, what is left of the dividend, and its quotient. *)
Section Quotient.

Variables (na ka nb kb k g : N).

Definition quotient_remainder : N * N :=
  let d := head ka na in
  let d' := bump d in
  let s1 := (d + d')%N in
  let s2 := (d + tiny s1)%N in
  let w := times (times d' slack) kb in
  let s3 := (bump s2 + bump w)%N in
  let s4 := (bump s3 + ka)%N in
  (bump s4, (s1 + (s2 + (w + (s3 + s4))))%N).

Definition quotient_rest : N := bump (times slack (fst quotient_remainder)).

Definition quotient_error : N :=
  let d := head ka na in
  let missing := times (times (bump d) slack) nb in
  let cross := times (times (ka + (tiny na + d)) slack) (k * one + tiny g) in
  let square := times slack (k * k * one + times g 2048) in
  (times slack (na + (snd quotient_remainder + (missing + (cross + square)))) + times slack (fst quotient_remainder))%N.

Variables (ma mb xa xb a a' b b' q p s1 s2 w s3 s4 l t : R).
Hypothesis Xa : Rabs xa <= ma.
Hypothesis Xb : Rabs xb <= mb.
Hypothesis Zb : xb <> 0.
Hypothesis Na : near na ma (a + a' - xa).
Hypothesis La : low ka ma a'.
Hypothesis Nb : near nb mb (b + b' - xb).
Hypothesis Lb : low kb mb b'.

(** The first part of the divisor is a factor times the exact value. *)
Hypothesis T0 : 0 <= t.
Hypothesis T : t * Rabs xb <= c g * (u * u) * mb.
Hypothesis D : IZR (Z.of_N k) * u + t <= 1 / 1024.
Variable r : R.
Hypothesis B : b = xb * r.
Hypothesis F : factor (IZR (Z.of_N k) * u + t) r.

Hypothesis Q : rounds (a / b) q.
Hypothesis P : rounds (q * b) p.
Hypothesis S1 : rounds (a - p) s1.
Hypothesis S2 : rounds (s1 - (q * b - p)) s2.
Hypothesis W : rounds (q * b') w.
Hypothesis S3 : rounds (s2 - w) s3.
Hypothesis S4 : rounds (s3 + a') s4.
Hypothesis L : rounds (s4 / b) l.

Let y := Rabs xb.
Let n := ma * (mb / y).
Let dev := IZR (Z.of_N k) * u + t.

Lemma y_pos : 0 < y.
Proof. now apply Rabs_pos_lt. Qed.

Lemma dev_pos : 0 <= IZR (Z.of_N k) * u.
Proof. positive_u. assert (0 <= IZR (Z.of_N k)) by (apply IZR_le; lia). nra. Qed.

Lemma ma_pos : 0 <= ma.
Proof. assert (H := Rabs_pos xa). lra. Qed.

Lemma wider : 1 <= mb / y.
Proof. assert (H := y_pos). apply Rmult_le_reg_r with y; [exact H|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; unfold y in *; lra. Qed.

Lemma ma_n : ma <= n.
Proof. assert (H := ma_pos). assert (G := wider). unfold n. nra. Qed.

Lemma r_range : 1 - dev <= r /\ 0 < r /\ / r <= 1024 / 1023 /\ Rabs (1 - r) <= 1024 / 1023 * dev.
Proof.
  assert (H := dev_pos). destruct F as (F1 & F2). fold dev in F1, F2, D. assert (dev <= 1 / 1024) by exact D.
  assert (0 <= dev) by (unfold dev; lra). assert (R : 1023 / 1024 <= r) by lra.
  split; [exact F1|]. split; [lra|]. split.
  - replace (1024 / 1023) with (/ (1023 / 1024)) by field. apply Rinv_le; lra.
  - assert (r <= 1024 / 1023).
    { apply Rmult_le_reg_r with (1 - dev); [lra|]. apply Rle_trans with (1 := F2). nra. }
    apply Rabs_le. split; [|lra].
    assert (r - 1 <= 1024 / 1023 * dev); [|lra].
    assert (r * (1 - dev) <= 1) by exact F2. nra.
Qed.

Lemma b_not_zero : b <> 0.
Proof. destruct r_range as (_ & R & _). rewrite B. apply Rmult_integral_contrapositive. split; [exact Zb | lra]. Qed.

Lemma inverse : Rabs (/ b) <= 1024 / 1023 * / y.
Proof.
  destruct r_range as (_ & R & I & _). rewrite B, Rinv_mult, Rabs_mult, !Rabs_inv, (Rabs_right r) by lra.
  fold y. assert (H := Rinv_0_lt_compat _ y_pos). nra.
Qed.

Lemma inverse_slack : Rabs (/ b) <= c slack * / y.
Proof. assert (H := inverse). assert (G := Rinv_0_lt_compat _ y_pos). rewrite c_slack. nra. Qed.

Lemma dividend : Rabs a <= c (head ka na) * ma.
Proof. now apply (head_bound ka na ma a a' xa ma_pos Xa La). Qed.

Lemma quotient_size : Rabs q <= c (times (bump (head ka na)) slack) * (ma * / y).
Proof.
  destruct Q as (d & Hd & ->). assert (H := half_unit). positive_u. assert (G := Rinv_0_lt_compat _ y_pos).
  replace (a / b * (1 + d)) with (a * (1 + d) * / b) by (unfold Rdiv; ring).
  apply (abs_mul _ _ (c (bump (head ka na))) (c slack)); [| exact inverse_slack | apply c_times | exact ma_pos | lra].
  apply Rle_trans with (c (head ka na) * (1 + u) * ma); [|apply scale; [apply c_bump | exact ma_pos]].
  rewrite Rabs_mult. assert (A := dividend). assert (Rabs (1 + d) <= 1 + u).
  { apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_R1. lra. }
  replace (c (head ka na) * (1 + u) * ma) with (c (head ka na) * ma * (1 + u)) by ring.
  apply Rmult_le_compat; try apply Rabs_pos; assumption.
Qed.

Lemma remainder_low : low (head ka na) ma (a - q * b).
Proof.
  destruct Q as (d & Hd & ->). assert (N := b_not_zero). replace (a - a / b * (1 + d) * b) with (- d * a) by (field; exact N).
  unfold low. rewrite Rabs_mult, Rabs_Ropp. assert (H := half_unit). assert (A := dividend). positive_u.
  replace (c (head ka na) * u * ma) with (u * (c (head ka na) * ma)) by ring.
  apply Rmult_le_compat; try apply Rabs_pos; lra.
Qed.

Lemma product_low : low (bump (head ka na)) ma (q * b - p).
Proof.
  apply error_low; [|exact P]. destruct Q as (d & Hd & ->). assert (N := b_not_zero).
  replace (a / b * (1 + d) * b) with (a * (1 + d)) by (field; exact N). assert (H := half_unit). positive_u.
  apply Rle_trans with (c (head ka na) * (1 + u) * ma); [|apply scale; [apply c_bump | exact ma_pos]].
  rewrite Rabs_mult. assert (A := dividend). assert (Rabs (1 + d) <= 1 + u).
  { apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_R1. lra. }
  replace (c (head ka na) * (1 + u) * ma) with (c (head ka na) * ma * (1 + u)) by ring.
  apply Rmult_le_compat; try apply Rabs_pos; assumption.
Qed.

Lemma quotient_times z m e : 0 <= m -> low e m z -> low (times (times (bump (head ka na)) slack) e) (ma * / y * m) (q * z).
Proof.
  intros M Z. assert (G := Rinv_0_lt_compat _ y_pos). assert (H := ma_pos).
  apply head_low; [nra | exact M | exact quotient_size | exact Z].
Qed.

Lemma quotient_times_near z m e : 0 <= m -> near e m z -> near (times (times (bump (head ka na)) slack) e) (ma * / y * m) (q * z).
Proof.
  intros M Z. assert (G := Rinv_0_lt_compat _ y_pos). assert (H := ma_pos). unfold near in *.
  apply (abs_mul q z (c (times (bump (head ka na)) slack)) (c e * (u * u))); [exact quotient_size | exact Z | | nra | exact M].
  rewrite <- Rmult_assoc. positive_u. apply scale; [apply c_times | nra].
Qed.

Lemma mb_pos : 0 <= mb.
Proof. assert (H := Rabs_pos xb). lra. Qed.

Lemma n_is : ma * / y * mb = n.
Proof. unfold n, Rdiv. ring. Qed.

(** What is left of the dividend. *)
Lemma remainder_holds :
  near (snd quotient_remainder) n (s4 - (a - q * b - q * b' + a')) /\ low (fst quotient_remainder) n s4.
Proof.
  assert (M := ma_pos). assert (I := ma_n). assert (N0 : 0 <= n) by lra. unfold quotient_remainder.
  set (d := head ka na). set (d' := bump d). set (c1 := (d + d')%N). set (c2 := (d + tiny c1)%N).
  set (cw := times (times d' slack) kb). set (c3 := (bump c2 + bump cw)%N). set (c4 := (bump c3 + ka)%N).
  assert (R := remainder_low). assert (E := product_low). fold d in R, E. fold d' in E.
  assert (L1 : low c1 ma (a - p)).
  { replace (a - p) with ((a - q * b) + (q * b - p)) by ring. now apply low_add. }
  destruct (low_rounded _ _ _ _ M L1 S1) as (N1 & _).
  assert (L2 : low c2 ma (s1 - (q * b - p))).
  { replace (s1 - (q * b - p)) with ((a - q * b) + (s1 - (a - p))) by ring. apply low_add; [exact R | now apply near_low]. }
  destruct (low_rounded _ _ _ _ M L2 S2) as (N2 & R2).
  assert (Lw := quotient_times b' mb kb mb_pos Lb). rewrite n_is in Lw. fold d d' cw in Lw.
  destruct (low_rounded _ _ _ _ N0 Lw W) as (Nw & Rw).
  assert (L3 : low c3 n (s2 - w)).
  { unfold Rminus. apply low_add; [now apply low_wide with ma | now apply low_opp]. }
  destruct (low_rounded _ _ _ _ N0 L3 S3) as (N3 & R3).
  assert (L4 : low c4 n (s3 + a')) by (apply low_add; [exact R3 | now apply low_wide with ma]).
  destruct (low_rounded _ _ _ _ N0 L4 S4) as (N4 & R4). cbn [fst snd]. split; [|exact R4].
  replace (s4 - (a - q * b - q * b' + a')) with ((s1 - (a - p)) + ((s2 - (s1 - (q * b - p)))
    + (- (w - q * b') + ((s3 - (s2 - w)) + (s4 - (s3 + a')))))) by ring.
  apply near_add; [now apply near_wide with ma|]. apply near_add; [now apply near_wide with ma|].
  apply near_add; [now apply near_opp|]. now apply near_add.
Qed.

(** The quotient of the first parts is not that of the numbers, and the remainder is divided by a first part alone. *)
Lemma cross_holds :
  near (times (times (ka + (tiny na + head ka na)) slack) (k * one + tiny g)) n
    ((a' - (a + a' - xa) + (a - q * b)) * ((xb - b) / b)).
Proof.
  assert (M := ma_pos). set (e := (ka + (tiny na + head ka na))%N).
  assert (A : low e ma (a' - (a + a' - xa) + (a - q * b))).
  { replace (a' - (a + a' - xa) + (a - q * b)) with (a' + (- (a + a' - xa) + (a - q * b))) by ring.
    apply low_add; [exact La|]. apply low_add; [apply low_opp; now apply near_low | exact remainder_low]. }
  assert (Rt : Rabs ((xb - b) / b) <= c slack * dev).
  { assert (N := b_not_zero). destruct r_range as (_ & R & I & J).
    replace ((xb - b) / b) with ((1 - r) * / r) by (rewrite B; field; split; [lra | exact Zb]).
    rewrite Rabs_mult, (Rabs_right (/ r)) by (apply Rle_ge, Rlt_le, Rinv_0_lt_compat; exact R).
    rewrite c_slack. assert (0 <= Rabs (1 - r)) by apply Rabs_pos. assert (0 < / r) by (apply Rinv_0_lt_compat; exact R).
    assert (0 <= dev) by (assert (H' := dev_pos); unfold dev; lra).
    apply Rle_trans with (1024 / 1023 * dev * (1024 / 1023)); [apply Rmult_le_compat; lra | lra]. }
  unfold near. rewrite Rabs_mult. unfold low in A.
  apply Rle_trans with (c e * u * ma * (c slack * dev)).
  { apply Rmult_le_compat; try apply Rabs_pos; assumption. }
  assert (H := dev_pos). positive_u. assert (Pe := c_pos e). assert (Ps := c_pos slack). assert (I := ma_n).
  assert (Tm : t * ma <= c g * (u * u) * n).
  { unfold n. assert (Y := y_pos). assert (Q0 : 0 <= ma / y) by (unfold Rdiv; assert (V := Rinv_0_lt_compat _ Y); nra).
    replace (t * ma) with (t * y * (ma / y)) by (field; lra).
    replace (c g * (u * u) * (ma * (mb / y))) with (c g * (u * u) * mb * (ma / y)) by (field; lra).
    apply scale; [exact T | exact Q0]. }
  assert (Km : IZR (Z.of_N k) * u * ma <= c (k * one) * u * n).
  { rewrite c_whole. assert (0 <= IZR (Z.of_N k)) by (apply IZR_le; lia). apply Rmult_le_compat_l; [nra | exact I]. }
  assert (Tg : c g * (u * u) * n <= c (tiny g) * u * n).
  { apply scale; [|lra]. rewrite <- Rmult_assoc. apply scale; [apply c_tiny | lra]. }
  assert (Dm : dev * ma <= c (k * one + tiny g) * u * n) by (unfold dev; rewrite c_add; lra).
  replace (c e * u * ma * (c slack * dev)) with (c e * c slack * u * (dev * ma)) by ring.
  assert (Ce := c_times e slack). assert (Cc := c_times (times e slack) (k * one + tiny g)).
  assert (Pk := c_pos (k * one + tiny g)).
  apply Rle_trans with (c (times e slack) * u * (c (k * one + tiny g) * u * n)).
  - assert (0 <= c e * c slack) by now apply Rmult_le_pos.
    apply Rmult_le_compat; [nra | apply Rmult_le_pos; [unfold dev; lra | exact M] | apply scale; lra | exact Dm].
  - replace (c (times e slack) * u * (c (k * one + tiny g) * u * n))
      with (c (times e slack) * c (k * one + tiny g) * (u * u) * n) by ring.
    apply scale; [|lra]. apply scale; [exact Cc | nra].
Qed.

Lemma square_holds :
  near (times slack (k * k * one + times g 2048)) n (xa / xb * ((xb - b) * ((xb - b) / b))).
Proof.
  assert (M := ma_pos). destruct r_range as (_ & R & I & J). assert (H := dev_pos). positive_u.
  replace (xa / xb * ((xb - b) * ((xb - b) / b))) with (xa * ((1 - r) * (1 - r) * / r))
    by (rewrite B; field; split; [lra | exact Zb]).
  assert (Z : Rabs ((1 - r) * (1 - r) * / r) <= c slack * (dev * dev)).
  { rewrite !Rabs_mult, (Rabs_right (/ r)) by (apply Rle_ge, Rlt_le, Rinv_0_lt_compat; exact R). rewrite c_slack.
    assert (P0 := Rabs_pos (1 - r)). assert (P1 : 0 <= dev) by (unfold dev; lra).
    assert (P2 := Rinv_0_lt_compat _ R).
    assert (Rabs (1 - r) * Rabs (1 - r) <= 1024 / 1023 * dev * (1024 / 1023 * dev)) by (apply Rmult_le_compat; assumption).
    apply Rle_trans with (1024 / 1023 * dev * (1024 / 1023 * dev) * (1024 / 1023)); [apply Rmult_le_compat; nra | nra]. }
  unfold near. rewrite Rabs_mult. set (kk := IZR (Z.of_N k)) in *.
  assert (Sq : dev * dev <= kk * kk * (u * u) + t * / 512).
  { unfold dev. assert (kk * u + t <= 1 / 1024) by exact D. nra. }
  assert (Tx : t * Rabs xa <= c g * (u * u) * n).
  { unfold n. assert (Y := y_pos). assert (Q0 : 0 <= Rabs xa / y)
      by (unfold Rdiv; assert (V := Rinv_0_lt_compat _ Y); assert (V' := Rabs_pos xa); nra).
    apply Rle_trans with (c g * (u * u) * mb * (Rabs xa / y)).
    - replace (t * Rabs xa) with (t * y * (Rabs xa / y)) by (field; lra). apply scale; [exact T | exact Q0].
    - replace (c g * (u * u) * (ma * (mb / y))) with (c g * (u * u) * mb * (ma / y)) by (field; lra).
      apply Rmult_le_compat_l; [assert (V := c_pos g); assert (V' := mb_pos); apply Rmult_le_pos; nra|].
      unfold Rdiv. apply scale; [exact Xa | apply Rlt_le, Rinv_0_lt_compat, Y]. }
  assert (Kx : kk * kk * (u * u) * Rabs xa <= c (k * k * one) * (u * u) * n).
  { rewrite c_whole, N2Z.inj_mul, mult_IZR. fold kk. assert (V := ma_n). apply Rmult_le_compat_l; [nra | lra]. }
  assert (Gx : c g * (u * u) * n * / 512 <= c (times g 2048) * (u * u) * n).
  { replace (c g * (u * u) * n * / 512) with (c g * / 512 * (u * u) * n) by ring. assert (V := ma_n).
    apply scale; [|lra]. apply scale; [|nra]. apply Rle_trans with (2 := c_times g 2048). right. f_equal.
    rewrite c_value. simpl. lra. }
  apply Rle_trans with (Rabs xa * (c slack * (dev * dev))).
  { apply Rmult_le_compat_l; [apply Rabs_pos | exact Z]. }
  assert (Ps := c_pos slack). assert (Px := Rabs_pos xa).
  apply Rle_trans with (c slack * c (k * k * one + times g 2048) * (u * u) * n).
  - rewrite c_add. replace (Rabs xa * (c slack * (dev * dev))) with (c slack * (dev * dev * Rabs xa)) by ring.
    replace (c slack * (c (k * k * one) + c (times g 2048)) * (u * u) * n)
      with (c slack * (c (k * k * one) * (u * u) * n + c (times g 2048) * (u * u) * n)) by ring.
    apply Rmult_le_compat_l; [exact Ps|].
    apply Rle_trans with ((kk * kk * (u * u) + t * / 512) * Rabs xa); [now apply scale|]. lra.
  - assert (V := ma_n). apply scale; [|lra]. apply scale; [apply c_times | nra].
Qed.

Lemma quotient_holds :
  near quotient_error (ma * mb / (xb * xb)) (q + l - xa / xb) /\ low quotient_rest (ma * mb / (xb * xb)) l.
Proof.
  assert (M := ma_pos). assert (I := ma_n). assert (N0 : 0 <= n) by lra. assert (Y := y_pos).
  assert (E : ma * mb / (xb * xb) = n / y).
  { unfold n. assert (xb * xb = y * y) as -> by (unfold y; rewrite <- Rabs_mult, Rabs_right; nra). field. lra. }
  rewrite E. assert (N1 : 0 <= n / y) by (unfold Rdiv; apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, Y]).
  destruct remainder_holds as (Nr & Lr). assert (N := b_not_zero).
  assert (Ll := low_over _ n b xb s4 N0 inverse_slack Zb Lr). fold y in Ll.
  destruct (low_rounded _ _ _ _ N1 Ll L) as (Nl & Rl). split; [|exact Rl]. unfold quotient_error.
  replace (q + l - xa / xb) with (((a + a' - xa) + ((s4 - (a - q * b - q * b' + a')) + (- (q * (b + b' - xb))
    + ((a' - (a + a' - xa) + (a - q * b)) * ((xb - b) / b) + - (xa / xb * ((xb - b) * ((xb - b) / b))))))) / b
    + (l - s4 / b)) by (field; split; assumption).
  apply near_add; [|exact Nl]. apply near_over; try assumption; [exact inverse_slack|].
  apply near_add; [now apply near_wide with ma|]. apply near_add; [exact Nr|]. apply near_add.
  - apply near_opp. rewrite <- n_is. apply quotient_times_near; [exact mb_pos | exact Nb].
  - apply near_add; [exact cross_holds | apply near_opp; exact square_holds].
Qed.

End Quotient.
