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

Lemma tiny_near_low e m : 0 <= m -> c e * (u * u) * m <= c (tiny e) * u * m.
Proof.
  intros M. apply scale; [|exact M]. positive_u. rewrite <- Rmult_assoc. apply scale; [apply c_tiny | lra].
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

Lemma head_near a b m n x y : 0 <= m -> 0 <= n -> Rabs x <= c a * m -> near b n y -> near (times a b) (m * n) (x * y).
Proof.
  intros M N X Y. unfold near in *. apply (abs_mul x y (c a) (c b * (u * u))); try assumption.
  rewrite <- Rmult_assoc. positive_u. apply scale; [apply c_times | nra].
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
