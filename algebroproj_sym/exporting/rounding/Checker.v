(** A checker of error bounds for straight-line programs in binary64, proved sound. *)

From Coq Require Import Reals ZArith NArith PArith List Bool FMapPositive Lia Lra.
From Flocq Require Import Core.
From Algebroproj Require Import Rounding Pairs.

Import ListNotations.
Open Scope R_scope.

(** ** Programs *)

Inductive operation :=
| Input (k : positive)
| Constant (z : Z)
| Neg (a : positive)
| Add (a b : positive)
| Join (a b : positive)
| Sub (a b : positive)
| Mul (a b : positive)
| Div (a b : positive)
| ProductError (a b p : positive).

Definition program := list (positive * operation).
Definition values := positive -> R.

(** The value of an operation: that of [ProductError a b p] is [a * b - p]. *)
Definition value (input e : values) (o : operation) : R :=
  match o with
  | Input k => input k
  | Constant z => IZR z
  | Neg a => - e a
  | Add a b | Join a b => e a + e b
  | Sub a b => e a - e b
  | Mul a b => e a * e b
  | Div a b => e a / e b
  | ProductError a b p => e a * e b - e p
  end.

(** The same with absolute values: sums of absolute values, which may be much larger than the sums.  A quotient has the
    condition numbers of both numbers.  The second number of [Join] is what was rounded off the first: it adds nothing. *)
Definition size (input x e : values) (o : operation) : R :=
  match o with
  | Input k => Rabs (input k)
  | Constant z => Rabs (IZR z)
  | Neg a => e a
  | Add a b | Sub a b => e a + e b
  | Join a _ => e a
  | Mul a b => e a * e b
  | Div a b => e a * e b / (x b * x b)
  | ProductError a b p => e a * e b + e p
  end.

Fixpoint run {A : Type} (step : (positive -> A) -> operation -> A) (p : program) (e : positive -> A) : positive -> A :=
  match p with
  | [] => e
  | (i, o) :: q => run step q (fun j => if Pos.eqb j i then step e o else e j)
  end.

Definition nothing : values := fun _ => 0.

(** What the machine computes, what it would compute without rounding, and the magnitudes of sums. *)
Definition computed (input : values) (p : program) := run (fun e o => RN (value input e o)) p nothing.
Definition exact (input : values) (p : program) := run (value input) p nothing.
Definition magnitude (input : values) (p : program) := run (size input (exact input p)) p nothing.

(** No product or quotient underflows. *)
Definition regular (f : values) (o : operation) : Prop :=
  match o with
  | Mul a b => normal_or_float (f a * f b)
  | Div a b => normal_or_float (f a / f b)
  | ProductError a b _ => f a * f b = 0 \/ smallest_exact_product <= Rabs (f a * f b)
  | _ => True
  end.

Definition all_regular (input : values) (p : program) : Prop :=
  Forall (fun named => regular (computed input p) (snd named)) p.

(** ** Well-formed programs: each name is greater than those before it *)

Definition operands (o : operation) : list positive :=
  match o with
  | Input _ | Constant _ => []
  | Neg a => [a]
  | Add a b | Join a b | Sub a b | Mul a b | Div a b => [a; b]
  | ProductError a b p => [a; b; p]
  end.

Definition is_representable (o : operation) : bool :=
  match o with Constant z => (Z.abs z <=? 2 ^ 53)%Z | _ => true end.

Fixpoint well_formed (n : positive) (p : program) : bool :=
  match p with
  | [] => true
  | (i, o) :: q =>
      (n <=? i)%positive && forallb (fun a => (a <? i)%positive) (operands o) && is_representable o
        && well_formed (Pos.succ i) q
  end.

Definition local {A : Type} (step : (positive -> A) -> operation -> A) :=
  forall e e' o, (forall a, In a (operands o) -> e a = e' a) -> step e o = step e' o.

Lemma local_value input : local (value input).
Proof. intros e e' [] H; simpl in *; rewrite ?(H a), ?(H b), ?(H p); auto. Qed.

Lemma local_rounded input : local (fun e o => RN (value input e o)).
Proof. intros e e' o H. f_equal. now apply local_value. Qed.

Lemma local_size input x : local (size input x).
Proof. intros e e' [] H; simpl in *; rewrite ?(H a), ?(H b), ?(H p); auto. Qed.

Lemma run_before {T} (step : (positive -> T) -> operation -> T) p : forall n e j, well_formed n p = true -> (j < n)%positive -> run step p e j = e j.
Proof.
  induction p as [|[i o] q IH]; intros n e j W J; [reflexivity|]. simpl in *.
  apply andb_prop in W as [W Wq]. apply andb_prop in W as [W _]. apply andb_prop in W as [W _].
  apply Pos.leb_le in W. rewrite (IH _ _ _ Wq) by lia.
  destruct (Pos.eqb_spec j i); [lia | reflexivity].
Qed.

Lemma run_value {T} (step : (positive -> T) -> operation -> T) p :
  local step -> forall n e i o, well_formed n p = true -> In (i, o) p -> run step p e i = step (run step p e) o.
Proof.
  intros L. induction p as [|[j k] q IH]; intros n e i o W I; [contradiction|]. simpl in *.
  apply andb_prop in W as [W Wq]. apply andb_prop in W as [W _]. apply andb_prop in W as [W Wa].
  destruct I as [E | I]; [|now apply (IH (Pos.succ j))].
  injection E as -> ->. rewrite (run_before _ _ _ _ _ Wq) by lia. rewrite Pos.eqb_refl.
  apply L. intros a A. rewrite forallb_forall in Wa. specialize (Wa a A). apply Pos.ltb_lt in Wa.
  rewrite (run_before _ _ _ _ _ Wq) by lia. destruct (Pos.eqb_spec a i); [lia | reflexivity].
Qed.

Lemma run_float input p : forall e, (forall j, is_float (e j)) -> forall j, is_float (run (fun e o => RN (value input e o)) p e j).
Proof.
  induction p as [|[i o] q IH]; intros e E j; [apply E|]. simpl. apply IH. intros k.
  destruct (Pos.eqb k i); [apply float_RN | apply E].
Qed.

Lemma well_formed_constant p : forall n i z, well_formed n p = true -> In (i, Constant z) p -> (Z.abs z <= 2 ^ 53)%Z.
Proof.
  induction p as [|[j k] q IH]; intros n i z W I; [contradiction|]. simpl in *.
  apply andb_prop in W as [W Wq]. apply andb_prop in W as [_ Wr].
  destruct I as [E | I]; [|now apply (IH _ i z Wq)]. injection E as -> ->. now apply Z.leb_le.
Qed.

Lemma float_constant z : (Z.abs z <= 2 ^ 53)%Z -> is_float (IZR z).
Proof.
  intros H. destruct (Z.eq_dec (Z.abs z) (2 ^ 53)) as [E | E].
  - assert (z = 2 ^ 53 \/ z = - 2 ^ 53)%Z as [-> | ->] by lia.
    + change (IZR (2 ^ 53)) with (bpow radix2 53). apply generic_format_bpow. unfold exponent, FLT_exp. lia.
    + change (IZR (- 2 ^ 53)) with (- bpow radix2 53). apply float_opp, generic_format_bpow. unfold exponent, FLT_exp. lia.
  - apply generic_format_FLT. apply (FLT_spec _ _ _ _ (Float radix2 z 0)); simpl; [|lia|lia].
    unfold F2R; simpl. ring.
Qed.

(** ** Facts *)

(** The sum of two values, [first + second], is near the exact value of [first]. *)
Record pair := Pair { first : positive; second : option positive; error : N; rest : N }.

(** What a rounded result is a factor times the exact one: [count] roundings, and coefficients of [u^2 * kappa]. *)
Definition terms := list (positive * N).

Definition partial (f : values) (l : option positive) : R := match l with Some i => f i | None => 0 end.

Definition kappa (x m : values) (j : positive) : R := Rabs (m j / x j).

Fixpoint total (x m : values) (t : terms) : R :=
  match t with [] => 0 | (j, k) :: s => c k * (u * u) * kappa x m j + total x m s end.

Definition roundings (k : N) : R := IZR (Z.of_N k).
Definition deviation (x m : values) (k : N) (t : terms) : R := roundings k * u + total x m t.

Definition not_zero (x : values) (t : terms) : Prop := Forall (fun term => x (fst term) <> 0) t.

Lemma total_pos x m t : 0 <= total x m t.
Proof.
  positive_u. induction t as [|[j k] t IH]; simpl; [lra|]. assert (0 <= kappa x m j) by apply Rabs_pos.
  assert (H1 := c_pos k). assert (0 <= c k * (u * u) * kappa x m j); [|lra]. apply Rmult_le_pos; [nra | assumption].
Qed.

Lemma roundings_pos k : 0 <= roundings k.
Proof. apply IZR_le. lia. Qed.

Lemma deviation_pos x m k t : 0 <= deviation x m k t.
Proof. positive_u. assert (H := total_pos x m t). assert (G := roundings_pos k). unfold deviation. nra. Qed.

Fixpoint add_term (j : positive) (k : N) (t : terms) : terms :=
  match t with
  | [] => [(j, k)]
  | (i, n) :: s =>
      match Pos.compare j i with
      | Lt => (j, k) :: t
      | Eq => (i, (n + k)%N) :: s
      | Gt => (i, n) :: add_term j k s
      end
  end.

Definition merge (s t : terms) : terms := fold_right (fun term => add_term (fst term) (snd term)) t s.

Lemma total_add_term x m j k t : total x m (add_term j k t) = c k * (u * u) * kappa x m j + total x m t.
Proof.
  induction t as [|[i n] t IH]; simpl; [reflexivity|]. destruct (Pos.compare_spec j i) as [-> | |]; simpl.
  - rewrite c_add. ring.
  - reflexivity.
  - rewrite IH. ring.
Qed.

Lemma total_merge x m s t : total x m (merge s t) = total x m s + total x m t.
Proof. induction s as [|[j k] s IH]; simpl; [ring|]. rewrite total_add_term, IH. ring. Qed.

Lemma not_zero_add_term x j k t : not_zero x (add_term j k t) -> x j <> 0 /\ not_zero x t.
Proof.
  induction t as [|[i n] t IH]; simpl; intros H.
  - inversion H; subst. split; [assumption | constructor].
  - destruct (Pos.compare_spec j i) as [-> | |]; inversion H; subst; simpl in *.
    + split; [assumption | constructor; assumption].
    + split; assumption.
    + destruct (IH H4). split; [assumption | constructor; assumption].
Qed.

Lemma not_zero_merge x s t : not_zero x (merge s t) -> not_zero x s /\ not_zero x t.
Proof.
  induction s as [|[j k] s IH]; simpl; intros H; [split; [constructor | assumption]|].
  apply not_zero_add_term in H as [J H]. destruct (IH H). split; [constructor|]; assumption.
Qed.

Definition single (j : positive) (k : N) : terms := if (k =? 0)%N then [] else [(j, k)].

(** Whether terms are contained in others, with coefficients that are not larger. *)
Fixpoint contained (s t : terms) : bool :=
  match t with
  | [] => match s with [] => true | _ => false end
  | (j, k) :: t' =>
      match s with
      | [] => true
      | (i, n) :: s' => if Pos.eqb i j then (n <=? k)%N && contained s' t' else contained s t'
      end
  end.

Lemma contained_total x m t : forall s, contained s t = true -> total x m s <= total x m t.
Proof.
  positive_u. induction t as [|[j k] t IH]; intros [|[i n] s] H; simpl in *; try discriminate; try lra.
  - assert (G := total_pos x m ((j, k) :: t)). exact G.
  - assert (P : 0 <= kappa x m j) by apply Rabs_pos. destruct (Pos.eqb_spec i j) as [-> | _].
    + apply andb_prop in H as [H1 H2]. apply N.leb_le, c_le in H1. apply IH in H2.
      assert (c n * (u * u) * kappa x m j <= c k * (u * u) * kappa x m j); [|lra].
      apply scale; [|exact P]. apply scale; [exact H1 | nra].
    + apply IH in H. simpl in H. assert (G := c_pos k).
      assert (0 <= c k * (u * u) * kappa x m j) by (apply Rmult_le_pos; [nra | exact P]). lra.
Qed.

Lemma contained_not_zero x t : forall s, contained s t = true -> not_zero x t -> not_zero x s.
Proof.
  induction t as [|[j k] t IH]; intros [|[i n] s] H N; simpl in *; try discriminate; try constructor.
  - destruct (Pos.eqb_spec i j) as [-> | _]; inversion N; subst; simpl in *; [assumption|].
    apply IH in H; [|assumption]. now inversion H.
  - destruct (Pos.eqb_spec i j) as [-> | _]; inversion N; subst.
    + apply andb_prop in H as [_ H]. now apply IH.
    + apply IH in H; [|assumption]. now inversion H.
Qed.

Lemma roundings_le k n : (k <= n)%N -> roundings k <= roundings n.
Proof. intros H. apply IZR_le. lia. Qed.

Lemma roundings_add k n : roundings (k + n) = roundings k + roundings n.
Proof. unfold roundings. rewrite N2Z.inj_add. apply plus_IZR. Qed.

(** ** Bounds *)

(** The name of a result, the number of roundings, and coefficients of [u^2] times a condition number. *)
Definition bound := (positive * (N * terms))%type.

(** The exact result is not so near a zero of a sum that the bound says nothing. *)
Definition applicable (x m : values) (b : bound) : Prop :=
  not_zero x (snd (snd b)) /\ deviation x m (fst (snd b)) (snd (snd b)) < 1.

Definition applies (input : values) (p : program) : bound -> Prop := applicable (exact input p) (magnitude input p).

(** A divisor is not zero, and not so near zero that rounding could make it so. *)
Definition determined (input : values) (p : program) (b : bound) : Prop :=
  exact input p (fst b) <> 0 /\ applies input p b.

(** ** Certificates *)

(** A pair by its number, or an exact value, which is a pair without a second part. *)
Inductive name := Known (id : positive) | Exactly (i : positive).

Inductive command :=
| ErrorOfSum (e p q w s t a b : positive)
| ErrorOfDifference (e p q w s t a b : positive)
| ErrorOfProduct (e a b t : positive)
| SumOf (id h : positive) (a b : name) (r : option positive)
| DifferenceOf (id h : positive) (a b : name) (r : option positive)
| LowOfSum (id sum e : positive) (l : option positive)
| ProductOf (id h : positive) (a b : name) (e : positive)
| ProductWithOne (id h : positive) (a b : name) (e k l : positive)
| ProductWithBoth (id h : positive) (a b : name) (partner : option positive) (e c1 c2 k l : positive)
| Separated (id pair y l : positive) (v : option positive)
| QuotientOf (id q : positive) (a b : name) (p e s1 s2 : positive) (divisor : option (positive * positive))
    (dividend : option positive) (l : positive)
| NegativeOf (id : positive) (a : positive) (h l : positive)
| RoundedPair (v id : positive)
| RoundedSum (v id : positive)
| FactorOf (v : positive)
| Mean (v : positive) (k : N) (t : terms)
| ZeroOf (v : positive)
| PlusZero (v a z : positive)
| NotNegative (v : positive).

Record facts := Facts {
  pairs : PositiveMap.t pair;
  sums : PositiveMap.t pair;
  errors : PositiveMap.t positive;
  factors : PositiveMap.t (N * terms);
  zeros : PositiveMap.t unit;
  not_negative : PositiveMap.t unit
}.

Definition no_facts : facts :=
  Facts (PositiveMap.empty _) (PositiveMap.empty _) (PositiveMap.empty _) (PositiveMap.empty _) (PositiveMap.empty _)
    (PositiveMap.empty _).

Section Checking.

Variable operations : PositiveMap.t operation.
Variable divisors : list bound.

Definition operation_of (i : positive) : option operation := PositiveMap.find i operations.

Definition is_exact (i : positive) : bool :=
  match operation_of i with
  | Some (Input _) | Some (Constant _) => true
  | Some (Neg a) => match operation_of a with Some (Input _) | Some (Constant _) => true | _ => false end
  | _ => false
  end.

Definition adds (t a b : positive) : bool :=
  match operation_of t with
  | Some (Add i j) | Some (Join i j) => (Pos.eqb i a && Pos.eqb j b) || (Pos.eqb i b && Pos.eqb j a)
  | _ => false
  end.

Definition is_joined (t : positive) : bool := match operation_of t with Some (Join _ _) => true | _ => false end.

Definition joins (t a b : positive) : bool :=
  match operation_of t with Some (Join i j) => Pos.eqb i a && Pos.eqb j b | _ => false end.

Definition divides (t a b : positive) : bool :=
  match operation_of t with Some (Div i j) => Pos.eqb i a && Pos.eqb j b | _ => false end.

Definition subtracts (t a b : positive) : bool :=
  match operation_of t with Some (Sub i j) => Pos.eqb i a && Pos.eqb j b | _ => false end.

Definition multiplies (t a b : positive) : bool :=
  match operation_of t with
  | Some (Mul i j) => (Pos.eqb i a && Pos.eqb j b) || (Pos.eqb i b && Pos.eqb j a)
  | _ => false
  end.

Definition negates (t a : positive) : bool :=
  match operation_of t with Some (Neg i) => Pos.eqb i a | _ => false end.

Definition takes_error (e a b t : positive) : bool :=
  match operation_of e with Some (ProductError i j p) => Pos.eqb i a && Pos.eqb j b && Pos.eqb p t | _ => false end.

Definition is_zero_constant (a : positive) : bool :=
  match operation_of a with Some (Constant 0) => true | _ => false end.

Definition is_zero (s : facts) (i : positive) : bool := PositiveMap.mem i (zeros s).

Definition pair_of (s : facts) (n : name) : option pair :=
  match n with
  | Known id => PositiveMap.find id (pairs s)
  | Exactly i => if is_exact i || is_zero s i then Some (Pair i None 0 0) else None
  end.

Definition factor_of (s : facts) (i : positive) : option (N * terms) :=
  if is_exact i then Some (0%N, []) else PositiveMap.find i (factors s).

Definition is_error (s : facts) (e t : positive) : bool :=
  match PositiveMap.find e (errors s) with Some i => Pos.eqb i t | None => false end.

Definition with_pair (s : facts) (id : positive) (p : pair) : facts :=
  Facts (PositiveMap.add id p (pairs s)) (sums s) (errors s) (factors s) (zeros s) (not_negative s).
Definition with_sum (s : facts) (id : positive) (p : pair) : facts :=
  Facts (pairs s) (PositiveMap.add id p (sums s)) (errors s) (factors s) (zeros s) (not_negative s).
Definition with_error (s : facts) (e t : positive) : facts :=
  Facts (pairs s) (sums s) (PositiveMap.add e t (errors s)) (factors s) (zeros s) (not_negative s).
Definition with_factor (s : facts) (v : positive) (k : N) (t : terms) : facts :=
  Facts (pairs s) (sums s) (errors s) (PositiveMap.add v (k, t) (factors s)) (zeros s) (not_negative s).
Definition with_zero (s : facts) (v : positive) : facts :=
  Facts (pairs s) (sums s) (errors s) (factors s) (PositiveMap.add v tt (zeros s)) (not_negative s).
Definition with_not_negative (s : facts) (v : positive) : facts :=
  Facts (pairs s) (sums s) (errors s) (factors s) (zeros s) (PositiveMap.add v tt (not_negative s)).

Definition guard {A : Type} (condition : bool) (a : A) : option A := if condition then Some a else None.

Definition same (r : option positive) (i : positive) : bool := match r with Some j => Pos.eqb j i | None => false end.

(** The rest of a sum: its second parts added, if there are two. *)
Definition rest_of_sum (adds' : positive -> positive -> positive -> bool) (negates' : positive -> positive -> bool)
  (h : positive) (a b : pair) (r : option positive) : option pair :=
  match second a, second b with
  | None, None => match r with None => Some (Pair h None (N.max (error a) (error b)) 0) | _ => None end
  | Some la, None => guard (same r la) (Pair h r (N.max (error a) (error b)) (N.max (rest a) 0))
  | None, Some lb =>
      match r with
      | Some i => guard (negates' i lb) (Pair h r (N.max (error a) (error b)) (N.max 0 (rest b)))
      | None => None
      end
  | Some la, Some lb =>
      match r with
      | Some i =>
          guard (adds' i la lb)
            (Pair h r (N.max (error a) (error b) + N.max (rest a) (rest b)) (bump (N.max (rest a) (rest b))))
      | None => None
      end
  end.

Definition zero_or (s : facts) (i : positive) : bool :=
  match PositiveMap.find i (not_negative s) with
  | Some _ => true
  | None => match operation_of i with Some (Constant z) => (0 <=? z)%Z | _ => false end
  end.

(** A divisor is a factor of at most 2^-10 times the exact value: roundings, and the coefficient of its own [u^2 * kappa]. *)
Definition divisor_of (s : facts) (y : positive) : option (N * N) :=
  let bounded k g :=
    guard (existsb (fun d => Pos.eqb (fst d) y && (1024 * k <=? fst (snd d))%N
      && contained (single y (1024 * g)) (snd (snd d))) divisors) (k, g) in
  match factor_of s y with
  | Some (k, []) => bounded k 0%N
  | Some (k, [(j, g)]) => if Pos.eqb j y then bounded k g else None
  | _ => None
  end.

Definition step (s : facts) (k : command) : option facts :=
  match k with
  | ErrorOfSum e p q w d t a b =>
      guard (adds e p q && subtracts p a w && subtracts w t d && subtracts d t a && subtracts q b d && adds t a b)
        (with_error s e t)
  | ErrorOfDifference e p q w d t a b =>
      guard (subtracts e p q && subtracts p a w && subtracts w t d && subtracts d t a && adds q b d && subtracts t a b)
        (with_error s e t)
  | ErrorOfProduct e a b t => guard (takes_error e a b t && multiplies t a b) (with_error s e t)
  | SumOf id h na nb r =>
      match pair_of s na, pair_of s nb with
      | Some a, Some b =>
          if adds h (first a) (first b) && negb (is_joined h)
          then option_map (with_sum s id) (rest_of_sum adds (fun i l => Pos.eqb i l) h a b r)
          else None
      | _, _ => None
      end
  | DifferenceOf id h na nb r =>
      match pair_of s na, pair_of s nb with
      | Some a, Some b =>
          if subtracts h (first a) (first b)
          then option_map (with_sum s id) (rest_of_sum subtracts negates h a b r)
          else None
      | _, _ => None
      end
  | LowOfSum id sum e l =>
      match PositiveMap.find sum (sums s) with
      | Some (Pair h r n k) =>
          let d := head k n in
          match r, l with
          | None, None => guard (is_error s e h) (with_pair s id (Pair h (Some e) n d))
          | Some r, Some l =>
              guard (is_error s e h && adds l r e) (with_pair s id (Pair h (Some l) (n + (k + d)) (bump (k + d))))
          | _, _ => None
          end
      | None => None
      end
  | ProductOf id h na nb e =>
      match pair_of s na, pair_of s nb with
      | Some (Pair a None n1 k1), Some (Pair b None n2 k2) =>
          let d := times (head k1 n1) (head k2 n2) in
          guard (multiplies h a b && is_error s e h) (with_pair s id (Pair h (Some e) (product_error n1 n2) d))
      | _, _ => None
      end
  | ProductWithOne id h na nb e k l =>
      match pair_of s na, pair_of s nb with
      | Some (Pair a (Some la) n1 k1), Some (Pair b None n2 k2) =>
          let d := times (head k1 n1) (head k2 n2) in
          let k1b := times k1 (head k2 n2) in
          let t := (bump k1b + d)%N in
          guard (multiplies h a b && is_error s e h && multiplies k la b && adds l k e)
            (with_pair s id (Pair h (Some l) (product_error n1 n2 + k1b + t) (bump t)))
      | _, _ => None
      end
  | ProductWithBoth id h na nb partner e c1 c2 k l =>
      match pair_of s na, pair_of s nb with
      | Some (Pair a (Some la) n1 k1), Some (Pair b (Some lb) n2 k2) =>
          let da := head k1 n1 in
          let db := head k2 n2 in
          let d := times da db in
          let '(b', db', missing) :=
            match partner with
            | None => (b, db, times k1 k2)
            | Some i => (i, bump (one + tiny n2), times k1 (one + tiny n2))
            end in
          let s1 := times da k2 in
          let s2 := times k1 db' in
          let s3 := (bump s1 + bump s2)%N in
          let t := (bump s3 + d)%N in
          guard
            (multiplies h a b && is_error s e h && multiplies c1 a lb && multiplies c2 la b' && adds k c1 c2
             && adds l k e && match partner with None => true | Some i => adds i b lb end)
            (with_pair s id (Pair h (Some l) (product_error n1 n2 + missing + s1 + s2 + s3 + t) (bump t)))
      | _, _ => None
      end
  | Separated id p y l v =>
      match PositiveMap.find p (pairs s) with
      | Some (Pair h (Some r) n k) =>
          let '(test, n', k') :=
            match v with
            | None => (is_error s l y, n, (one + tiny n)%N)
            | Some v => (subtracts v y h && subtracts l r v, separated_error k n, separated_rest k n)
            end in
          guard (joins y h r && test) (with_factor (with_pair s id (Pair y (Some l) n' k')) y 1 (single y n))
      | _ => None
      end
  | QuotientOf id q na nb p e s1 s2 divisor dividend l =>
      match pair_of s na, pair_of s nb with
      | Some (Pair a la n1 k1), Some (Pair b lb n2 k2) =>
          let s3 := match divisor with Some (_, i) => i | None => s2 end in
          let s4 := match dividend with Some i => i | None => s3 end in
          match divisor_of s b with
          | Some (k, g) =>
              guard
                (divides q a b && multiplies p q b && is_error s e p && subtracts s1 a p && subtracts s2 s1 e
                 && match lb, divisor with
                    | Some lb, Some (w, i) => multiplies w q lb && subtracts i s2 w
                    | None, None => true
                    | _, _ => false
                    end
                 && match la, dividend with Some la, Some i => adds i s3 la | None, None => true | _, _ => false end
                 && divides l s4 b)
                (with_pair s id (Pair q (Some l) (quotient_error n1 k1 n2 k2 k g) (quotient_rest n1 k1 k2)))
          | None => None
          end
      | _, _ => None
      end
  | NegativeOf id p h l =>
      match PositiveMap.find p (pairs s) with
      | Some (Pair a (Some la) n k) => guard (negates h a && negates l la) (with_pair s id (Pair h (Some l) n k))
      | _ => None
      end
  | RoundedPair v id =>
      match PositiveMap.find id (pairs s) with
      | Some (Pair h (Some l) n k) => guard (adds v h l) (with_factor s v 1 (single h n))
      | _ => None
      end
  | RoundedSum v id =>
      match PositiveMap.find id (sums s) with
      | Some (Pair h (Some r) n k) => guard (adds v h r) (with_factor s v 2 (single h (bump n + k)))
      | Some (Pair h None n k) => guard (Pos.eqb v h) (with_factor s v 1 (single h (bump n + k)))
      | None => None
      end
  | FactorOf v =>
      match operation_of v with
      | Some (Mul a b) | Some (Div a b) =>
          match factor_of s a, factor_of s b with
          | Some (k1, t1), Some (k2, t2) => Some (with_factor s v (k1 + k2 + 1) (merge t1 t2))
          | _, _ => None
          end
      | Some (Neg a) => match factor_of s a with Some (k, t) => Some (with_factor s v k t) | None => None end
      | _ => None
      end
  | Mean v k t =>
      match operation_of v with
      | Some (Add a b) =>
          match factor_of s a, factor_of s b with
          | Some (k1, t1), Some (k2, t2) =>
              guard (zero_or s a && zero_or s b && (k1 <=? k)%N && (k2 <=? k)%N && contained t1 t && contained t2 t)
                (with_factor s v (k + 1) t)
          | _, _ => None
          end
      | _ => None
      end
  | ZeroOf v =>
      match operation_of v with
      | Some (Mul a b) | Some (Div a b) => guard (is_zero_constant a) (with_zero s v)
      | Some (Add a b) => guard (is_zero s a && is_zero s b) (with_zero s v)
      | _ => None
      end
  | PlusZero v a z =>
      match PositiveMap.find z (zeros s), factor_of s a with
      | Some _, Some (k, t) => guard (adds v a z || subtracts v z a) (with_factor s v k t)
      | _, _ => None
      end
  | NotNegative v =>
      match operation_of v with
      | Some (Mul a b) => guard (Pos.eqb a b || (zero_or s a && zero_or s b)) (with_not_negative s v)
      | Some (Add a b) | Some (Div a b) => guard (zero_or s a && zero_or s b) (with_not_negative s v)
      | _ => None
      end
  end.

Fixpoint follow (s : facts) (cert : list command) : option facts :=
  match cert with
  | [] => Some s
  | k :: rest => match step s k with Some s' => follow s' rest | None => None end
  end.

(** ** Soundness *)

Variables (input f x m : values).

Hypothesis f_value : forall i o, operation_of i = Some o -> f i = RN (value input f o).
Hypothesis x_value : forall i o, operation_of i = Some o -> x i = value input x o.
Hypothesis m_value : forall i o, operation_of i = Some o -> m i = size input x m o.
Hypothesis f_float : forall i, is_float (f i).
Hypothesis input_float : forall k, is_float (input k).
Hypothesis constant_float : forall i z, operation_of i = Some (Constant z) -> is_float (IZR z).
Hypothesis f_regular : forall i o, operation_of i = Some o -> regular f o.
Hypothesis x_divisor : forall i a b, operation_of i = Some (Div a b) -> x b <> 0.
Hypothesis x_determined : Forall (fun d => x (fst d) <> 0 /\ applicable x m d) divisors.

Definition before_rounding (i : positive) : R :=
  match operation_of i with Some o => value input f o | None => 0 end.

Definition pair_holds (p : pair) : Prop :=
  partial x (second p) = 0
  /\ near (error p) (m (first p)) (f (first p) + partial f (second p) - x (first p))
  /\ low (rest p) (m (first p)) (partial f (second p))
  /\ Rabs (x (first p)) <= m (first p).

Definition sum_holds (p : pair) : Prop :=
  partial x (second p) = 0
  /\ rounds (before_rounding (first p)) (f (first p))
  /\ near (error p) (m (first p)) (before_rounding (first p) + partial f (second p) - x (first p))
  /\ low (rest p) (m (first p)) (partial f (second p))
  /\ Rabs (x (first p)) <= m (first p).

Definition error_holds (e t : positive) : Prop := f e = before_rounding t - f t /\ x e = 0.

Definition factor_holds (v : positive) (k : N) (t : terms) : Prop :=
  not_zero x t -> deviation x m k t < 1 -> exists p, f v = x v * p /\ factor (deviation x m k t) p.

Record sound (s : facts) : Prop := {
  sound_pairs : forall id p, PositiveMap.find id (pairs s) = Some p -> pair_holds p;
  sound_sums : forall id p, PositiveMap.find id (sums s) = Some p -> sum_holds p;
  sound_errors : forall e t, PositiveMap.find e (errors s) = Some t -> error_holds e t;
  sound_factors : forall v k t, PositiveMap.find v (factors s) = Some (k, t) -> factor_holds v k t;
  sound_zeros : forall v y, PositiveMap.find v (zeros s) = Some y -> f v = 0 /\ x v = 0 /\ m v = 0;
  sound_not_negative : forall v y, PositiveMap.find v (not_negative s) = Some y -> 0 <= x v
}.

(** *** What the tests say *)

Lemma before i o : operation_of i = Some o -> before_rounding i = value input f o.
Proof. intros H. unfold before_rounding. now rewrite H. Qed.

Lemma pair_test (p q a b : positive) :
  (Pos.eqb p a && Pos.eqb q b) || (Pos.eqb p b && Pos.eqb q a) = true -> p = a /\ q = b \/ p = b /\ q = a.
Proof. intros H. apply orb_prop in H as [H | H]; apply andb_prop in H as [H1 H2]; apply Pos.eqb_eq in H1, H2; auto. Qed.

Lemma adds_true t a b :
  adds t a b = true ->
  before_rounding t = f a + f b /\ f t = RN (f a + f b) /\ x t = x a + x b
  /\ (is_joined t = false -> m t = m a + m b) /\ rounds (f a + f b) (f t).
Proof.
  unfold adds, is_joined. destruct (operation_of t) as [[]|] eqn:E; try discriminate; intros H;
    assert (F := f_value _ _ E); assert (X := x_value _ _ E); assert (M := m_value _ _ E); simpl in F, X, M;
    rewrite (before _ _ E); simpl; assert (S := rounds_sum (f a) (f b) (f_float a) (f_float b));
    (apply pair_test in H as [[-> ->] | [-> ->]];
      [|rewrite (Rplus_comm (f b)) in F; rewrite (Rplus_comm (f b))]);
    rewrite F, X, ?M; repeat split; try assumption; try discriminate; intros; ring.
Qed.

Lemma joins_true t a b : joins t a b = true -> x t = x a + x b /\ m t = m a /\ rounds (f a + f b) (f t).
Proof.
  unfold joins. destruct (operation_of t) as [[]|] eqn:E; try discriminate. intros H.
  apply andb_prop in H as [H1 H2]. apply Pos.eqb_eq in H1, H2. subst.
  assert (F := f_value _ _ E). assert (X := x_value _ _ E). assert (M := m_value _ _ E). simpl in F, X, M.
  rewrite F. repeat split; try assumption. now apply rounds_sum.
Qed.

Lemma divides_true t a b :
  divides t a b = true ->
  x b <> 0 /\ x t = x a / x b /\ m t = m a * m b / (x b * x b) /\ rounds (f a / f b) (f t).
Proof.
  unfold divides. destruct (operation_of t) as [[]|] eqn:E; try discriminate. intros H.
  apply andb_prop in H as [H1 H2]. apply Pos.eqb_eq in H1, H2. subst.
  assert (F := f_value _ _ E). assert (X := x_value _ _ E). assert (M := m_value _ _ E).
  assert (G := f_regular _ _ E). simpl in F, X, M, G. rewrite F. repeat split; try assumption.
  - exact (x_divisor _ _ _ E).
  - now apply rounds_normal.
Qed.

Lemma subtracts_true t a b :
  subtracts t a b = true ->
  before_rounding t = f a - f b /\ f t = RN (f a - f b) /\ x t = x a - x b /\ m t = m a + m b
  /\ rounds (f a - f b) (f t).
Proof.
  unfold subtracts. destruct (operation_of t) as [[]|] eqn:E; try discriminate. intros H.
  apply andb_prop in H as [H1 H2]. apply Pos.eqb_eq in H1, H2. subst.
  assert (F := f_value _ _ E). assert (X := x_value _ _ E). assert (M := m_value _ _ E). simpl in F, X, M.
  rewrite (before _ _ E). simpl. rewrite F. repeat split; try assumption.
  now apply rounds_difference.
Qed.

Lemma multiplies_true t a b :
  multiplies t a b = true ->
  before_rounding t = f a * f b /\ f t = RN (f a * f b) /\ x t = x a * x b /\ m t = m a * m b
  /\ rounds (f a * f b) (f t).
Proof.
  unfold multiplies. destruct (operation_of t) as [[]|] eqn:E; try discriminate. intros H.
  assert (F := f_value _ _ E). assert (X := x_value _ _ E). assert (M := m_value _ _ E).
  assert (G := f_regular _ _ E). simpl in F, X, M, G. rewrite (before _ _ E). simpl.
  apply pair_test in H as [[-> ->] | [-> ->]].
  - rewrite F. repeat split; try assumption. now apply rounds_normal.
  - rewrite (Rmult_comm (f b)) in F. rewrite F, (Rmult_comm (f b)), X, M.
    rewrite (Rmult_comm (f b)) in G. repeat split; try ring. now apply rounds_normal.
Qed.

Lemma negates_true t a : negates t a = true -> f t = - f a /\ x t = - x a /\ m t = m a.
Proof.
  unfold negates. destruct (operation_of t) as [[]|] eqn:E; try discriminate. intros H. apply Pos.eqb_eq in H. subst.
  assert (F := f_value _ _ E). assert (X := x_value _ _ E). assert (M := m_value _ _ E). simpl in F, X, M.
  repeat split; try assumption. rewrite F, RN_opp. f_equal. apply RN_float, f_float.
Qed.

Lemma takes_error_true e a b t :
  takes_error e a b t = true -> f t = RN (f a * f b) -> f e = f a * f b - f t /\ x e = x a * x b - x t.
Proof.
  unfold takes_error. destruct (operation_of e) as [[]|] eqn:E; try discriminate. intros H T.
  apply andb_prop in H as [H H3]. apply andb_prop in H as [H1 H2]. apply Pos.eqb_eq in H1, H2, H3. subst.
  assert (F := f_value _ _ E). assert (X := x_value _ _ E). assert (G := f_regular _ _ E). simpl in F, X, G.
  split; [|exact X]. rewrite F, T. apply exact_product_error; auto.
Qed.

Lemma is_exact_true i : is_exact i = true -> f i = x i /\ m i = Rabs (x i).
Proof.
  assert (Base : forall j, match operation_of j with Some (Input _) | Some (Constant _) => true | _ => false end = true ->
    f j = x j /\ m j = Rabs (x j)).
  { intros j. destruct (operation_of j) as [[]|] eqn:E; try discriminate; intros _;
    assert (F := f_value _ _ E); assert (X := x_value _ _ E); assert (M := m_value _ _ E); simpl in F, X, M;
    rewrite F, X, M; split; try reflexivity; apply RN_float; eauto. }
  unfold is_exact. intros H. destruct (operation_of i) as [[]|] eqn:E; try discriminate.
  - apply Base. now rewrite E.
  - apply Base. now rewrite E.
  - destruct (negates_true i a) as (F & X & M). { unfold negates. rewrite E. apply Pos.eqb_refl. }
    destruct (Base a H) as (Fa & Ma). rewrite F, X, M, Fa, Ma, Rabs_Ropp. auto.
Qed.

Lemma is_zero_true s i : sound s -> is_zero s i = true -> f i = 0 /\ x i = 0 /\ m i = 0.
Proof.
  intros S E. unfold is_zero in E. rewrite PositiveMap.mem_find in E.
  destruct (PositiveMap.find i (zeros s)) as [y|] eqn:Z; [|discriminate]. exact (sound_zeros _ S i y Z).
Qed.

Lemma pair_of_holds s n p : sound s -> pair_of s n = Some p -> pair_holds p.
Proof.
  intros S H. destruct n as [id | i]; simpl in H; [now apply (sound_pairs _ S id)|].
  destruct (is_exact i || is_zero s i)%bool eqn:E; [|discriminate]. injection H as <-.
  assert (f i = x i /\ m i = Rabs (x i)) as (F & M).
  { apply orb_prop in E as [E | E]; [now apply is_exact_true|]. destruct (is_zero_true s i S E) as (-> & -> & ->).
    now rewrite Rabs_R0. }
  assert (P : 0 <= m i) by (rewrite M; apply Rabs_pos).
  repeat split; simpl.
  - rewrite F. replace (x i + 0 - x i) with 0 by ring. now apply near_0.
  - now apply low_0.
  - rewrite M. lra.
Qed.

Lemma factor_of_holds s v k t : sound s -> factor_of s v = Some (k, t) -> factor_holds v k t.
Proof.
  intros S. unfold factor_of. destruct (is_exact v) eqn:E; [|now apply (sound_factors _ S)].
  intros H. injection H as <- <-. intros _ _. exists 1. destruct (is_exact_true v E) as (F & _). rewrite F.
  split; [ring|]. unfold deviation, roundings; simpl. split; lra.
Qed.

Lemma is_error_true s e t : sound s -> is_error s e t = true -> error_holds e t.
Proof.
  intros S. unfold is_error. destruct (PositiveMap.find e (errors s)) eqn:E; [|discriminate]. intros H.
  apply Pos.eqb_eq in H. subst. now apply (sound_errors _ S).
Qed.

Lemma zero_or_true s i : sound s -> zero_or s i = true -> 0 <= x i.
Proof.
  intros S. unfold zero_or. destruct (PositiveMap.find i (not_negative s)) eqn:E; [intros _; now apply (sound_not_negative _ S i _ E)|].
  destruct (operation_of i) as [[]|] eqn:O; try discriminate. intros H. apply Z.leb_le in H.
  rewrite (x_value _ _ O). simpl. now apply IZR_le.
Qed.

(** *** How facts are added *)

Lemma find_add {A} i j (a : A) map b :
  PositiveMap.find i (PositiveMap.add j a map) = Some b -> i = j /\ b = a \/ PositiveMap.find i map = Some b.
Proof.
  destruct (Pos.eq_dec i j) as [-> | N].
  - rewrite PositiveMap.gss. intros H. injection H as <-. auto.
  - rewrite PositiveMap.gso by exact N. auto.
Qed.

Ltac add_fact :=
  intros S H; destruct S; constructor; simpl; try assumption;
  let F := fresh in intros; lazymatch goal with G : PositiveMap.find _ (PositiveMap.add _ _ _) = Some _ |- _ =>
    apply find_add in G as [[? F] | F]; [subst | eauto] end.

Lemma add_pair s id p : sound s -> pair_holds p -> sound (with_pair s id p).
Proof. add_fact. assumption. Qed.
Lemma add_sum s id p : sound s -> sum_holds p -> sound (with_sum s id p).
Proof. add_fact. assumption. Qed.
Lemma add_error s e t : sound s -> error_holds e t -> sound (with_error s e t).
Proof. add_fact. assumption. Qed.
Lemma add_factor s v k t : sound s -> factor_holds v k t -> sound (with_factor s v k t).
Proof. add_fact. match goal with G : (_, _) = (_, _) |- _ => injection G as -> -> end. assumption. Qed.
Lemma add_zero s v : sound s -> f v = 0 /\ x v = 0 /\ m v = 0 -> sound (with_zero s v).
Proof. add_fact. assumption. Qed.
Lemma add_not_negative s v : sound s -> 0 <= x v -> sound (with_not_negative s v).
Proof. add_fact. assumption. Qed.

Lemma guard_true {A} condition (a b : A) : guard condition a = Some b -> condition = true /\ a = b.
Proof. unfold guard. destruct condition; [|discriminate]. intros H. injection H. auto. Qed.

Ltac tests H :=
  repeat match type of H with _ && _ = true => let G := fresh "T" in apply andb_prop in H as [H G] end.

(** *** The rules *)

Lemma error_of_sum e p q w d t a b :
  adds e p q && subtracts p a w && subtracts w t d && subtracts d t a && subtracts q b d && adds t a b = true ->
  error_holds e t.
Proof.
  intros H. tests H.
  apply adds_true in H as (_ & Fe & Xe & _). apply subtracts_true in T3 as (_ & Fp & Xp & _).
  apply subtracts_true in T2 as (_ & Fw & Xw & _). apply subtracts_true in T1 as (_ & Fd & Xd & _).
  apply subtracts_true in T0 as (_ & Fq & Xq & _). apply adds_true in T as (Bt & Ft & Xt & _).
  split; [|lra]. rewrite Bt, Fe, Fp, Fq, Fw, Fd, Ft. apply sum_error; apply f_float.
Qed.

Lemma error_of_difference e p q w d t a b :
  subtracts e p q && subtracts p a w && subtracts w t d && subtracts d t a && adds q b d && subtracts t a b = true ->
  error_holds e t.
Proof.
  intros H. tests H.
  apply subtracts_true in H as (_ & Fe & Xe & _). apply subtracts_true in T3 as (_ & Fp & Xp & _).
  apply subtracts_true in T2 as (_ & Fw & Xw & _). apply subtracts_true in T1 as (_ & Fd & Xd & _).
  apply adds_true in T0 as (_ & Fq & Xq & _). apply subtracts_true in T as (Bt & Ft & Xt & _).
  split; [|lra]. rewrite Bt, Fe, Fp, Fq, Fw, Fd, Ft. apply difference_error; apply f_float.
Qed.

Lemma error_of_product e a b t : takes_error e a b t && multiplies t a b = true -> error_holds e t.
Proof.
  intros H. tests H. apply multiplies_true in T as (Bt & Ft & Xt & _).
  apply takes_error_true in H as (Fe & Xe); [|exact Ft]. split; [now rewrite Fe, Bt | lra].
Qed.

Lemma magnitude_pos p : pair_holds p -> 0 <= m (first p).
Proof. intros (_ & _ & _ & H). assert (P := Rabs_pos (x (first p))). lra. Qed.

Lemma sum_magnitude a b k l : Rabs a <= k -> Rabs b <= l -> Rabs (a + b) <= k + l.
Proof. intros A B. apply Rle_trans with (1 := Rabs_triang a b). lra. Qed.

(** Sums and differences at once: [g] is 1 or -1. *)
Lemma signed_sum g h a b r p adds' negates' :
  (g = 1 \/ g = -1) -> pair_holds a -> pair_holds b ->
  before_rounding h = f (first a) + g * f (first b) -> x h = x (first a) + g * x (first b) ->
  m h = m (first a) + m (first b) -> rounds (before_rounding h) (f h) ->
  (forall t i j, adds' t i j = true -> x t = x i + g * x j /\ rounds (f i + g * f j) (f t)) ->
  (forall t i, negates' t i = true -> f t = g * f i /\ x t = g * x i) ->
  rest_of_sum adds' negates' h a b r = Some p -> sum_holds p.
Proof.
  intros G A B Bh Xh Mh R Adds Negates H.
  assert (Ma := magnitude_pos a A). assert (Mb := magnitude_pos b B).
  destruct A as (Za & Na & La & Xa). destruct B as (Zb & Nb & Lb & Xb).
  assert (X : Rabs (x h) <= m h).
  { rewrite Xh, Mh. apply sum_magnitude; [assumption|]. destruct G as [-> | ->].
    - now rewrite Rmult_1_l.
    - replace (-1 * x (first b)) with (- x (first b)) by ring. now rewrite Rabs_Ropp. }
  assert (N : near (N.max (error a) (error b)) (m h)
    (before_rounding h + (partial f (second a) + g * partial f (second b)) - x h)).
  { rewrite Bh, Xh, Mh.
    replace (f (first a) + g * f (first b) + (partial f (second a) + g * partial f (second b))
      - (x (first a) + g * x (first b))) with ((f (first a) + partial f (second a) - x (first a))
      + g * (f (first b) + partial f (second b) - x (first b))) by ring.
    apply near_sum; try assumption. destruct G as [-> | ->].
    - now rewrite Rmult_1_l.
    - match goal with |- near _ _ (-1 * ?y) => replace (-1 * y) with (- y) by ring end. now apply near_opp. }
  assert (Lg : low (rest b) (m (first b)) (g * partial f (second b))).
  { destruct G as [-> | ->].
    - now rewrite Rmult_1_l.
    - match goal with |- low _ _ (-1 * ?y) => replace (-1 * y) with (- y) by ring end. now apply low_opp. }
  assert (M : 0 <= m h) by lra.
  assert (L : low (N.max (rest a) (rest b)) (m h) (partial f (second a) + g * partial f (second b))).
  { rewrite Mh. now apply low_sum. }
  unfold rest_of_sum in H. destruct (second a) as [la|] eqn:Ea, (second b) as [lb|] eqn:Eb; simpl in *.
  - destruct r as [i|]; [|discriminate]. apply guard_true in H as [T <-]. apply Adds in T as (Xi & Ri).
    destruct (low_rounded _ _ _ _ M L Ri) as (Q1 & Q2).
    repeat split; simpl; try assumption.
    + rewrite Xi. destruct G as [-> | ->]; lra.
    + replace (before_rounding h + f i - x h) with ((before_rounding h + (f la + g * f lb) - x h) + (f i - (f la + g * f lb)))
        by ring. now apply near_add.
  - apply guard_true in H as [T <-]. destruct r as [i|]; [|discriminate]. simpl in T. apply Pos.eqb_eq in T. subst i.
    rewrite Rmult_0_r, Rplus_0_r in *. repeat split; simpl; try assumption.
    apply (low_le (rest a)); [lia | exact M|]. unfold low in *. apply Rle_trans with (1 := La).
    rewrite Mh. positive_u. assert (0 <= c (rest a) * u) by (assert (Q := c_pos (rest a)); nra). nra.
  - destruct r as [i|]; [|discriminate]. apply guard_true in H as [T <-]. apply Negates in T as (Fi & Xi).
    rewrite Rplus_0_l in *. repeat split; simpl; try assumption.
    + rewrite Xi, Zb. ring.
    + now rewrite Fi.
    + rewrite Fi. apply (low_le (rest b)); [lia | exact M|]. unfold low in *. apply Rle_trans with (1 := Lg).
      rewrite Mh. positive_u. assert (0 <= c (rest b) * u) by (assert (Q := c_pos (rest b)); nra). nra.
  - destruct r as [i|]; [discriminate|]. injection H as <-. rewrite Rmult_0_r, Rplus_0_r in *.
    repeat split; simpl; try assumption. now apply low_0.
Qed.

Lemma low_of_sum h r n k e l :
  sum_holds (Pair h (Some r) n k) -> error_holds e h -> adds l r e = true ->
  pair_holds (Pair h (Some l) (n + (k + head k n)) (bump (k + head k n))).
Proof.
  intros (Zr & R & N & L & X) (Fe & Xe) T. simpl in *. apply adds_true in T as (_ & _ & Xl & _ & Rl).
  assert (M : 0 <= m h) by (assert (P := Rabs_pos (x h)); lra).
  assert (H := head_bound _ _ _ _ _ _ M X L N). rewrite Fe in Rl.
  destruct (with_rest _ _ _ _ _ _ _ _ _ M H R L N Rl) as (A & B).
  repeat split; simpl; try assumption. lra.
Qed.

Lemma low_of_exact_sum h n k e :
  sum_holds (Pair h None n k) -> error_holds e h -> pair_holds (Pair h (Some e) n (head k n)).
Proof.
  intros (_ & R & N & L & X) (Fe & Xe). simpl in *.
  assert (M : 0 <= m h) by (assert (P := Rabs_pos (x h)); lra).
  assert (H := head_bound _ _ _ _ _ _ M X L N). repeat split; simpl; try assumption.
  - rewrite Fe. replace (f h + (before_rounding h - f h) - x h) with (before_rounding h + 0 - x h) by ring. exact N.
  - rewrite Fe. now apply error_low.
Qed.

Lemma pair_head p : pair_holds p -> Rabs (f (first p)) <= c (head (rest p) (error p)) * m (first p).
Proof.
  intros P. assert (M := magnitude_pos p P). destruct P as (_ & N & L & X). now apply (head_bound _ _ _ _ _ _ M X L N).
Qed.

Lemma product_magnitude a b k l : Rabs a <= k -> Rabs b <= l -> Rabs (a * b) <= k * l.
Proof. intros A B. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; assumption. Qed.

(** The error of a product of pairs, before their second parts are multiplied, and the second part that it has. *)
Lemma product_of a b h e :
  pair_holds a -> pair_holds b -> multiplies h (first a) (first b) = true -> error_holds e h ->
  near (product_error (error a) (error b)) (m h)
    ((f (first a) + partial f (second a)) * (f (first b) + partial f (second b)) - x h)
  /\ low (times (head (rest a) (error a)) (head (rest b) (error b))) (m h) (f e)
  /\ Rabs (x h) <= m h /\ 0 <= m h /\ f e = f (first a) * f (first b) - f h /\ x e = 0
  /\ m h = m (first a) * m (first b).
Proof.
  intros A B T (Fe & Xe). assert (Ma := magnitude_pos a A). assert (Mb := magnitude_pos b B).
  assert (Ha := pair_head a A). assert (Hb := pair_head b B).
  apply multiplies_true in T as (Bh & Fh & Xh & Mh & R). rewrite Bh in Fe.
  assert (H := head_times _ _ _ _ _ _ Ma Mb Ha Hb). rewrite <- Mh in H.
  destruct A as (Za & Na & La & Xa). destruct B as (Zb & Nb & Lb & Xb).
  split; [|split; [|split; [|split; [|split; [|split]]]]]; try assumption.
  - rewrite Xh, Mh. now apply exact_product.
  - rewrite Fe. now apply error_low.
  - rewrite Xh, Mh. now apply product_magnitude.
  - rewrite Mh. now apply Rmult_le_pos.
Qed.

(** The end of all products: what was rounded off the first part, and products with second parts [k]. *)
Lemma product_end h e k l g s d :
  0 <= m h -> Rabs (x h) <= m h -> error_holds e h -> before_rounding h = f h + f e -> x k = 0 ->
  near g (m h) (f h + f e + f k - x h) -> low s (m h) (f k) -> low d (m h) (f e) -> adds l k e = true ->
  pair_holds (Pair h (Some l) (g + (s + d)) (bump (s + d))).
Proof.
  intros M X (Fe & Xe) Bh Zk N S D T. apply adds_true in T as (_ & _ & Xl & _ & Rl).
  destruct (low_rounded _ _ _ _ M (low_add _ _ _ _ _ S D) Rl) as (A & B).
  repeat split; simpl; try assumption; [lra|].
  replace (f h + f l - x h) with ((f h + f e + f k - x h) + (f l - (f k + f e))) by ring. now apply near_add.
Qed.

Lemma product_with_one a la n1 k1 b n2 k2 h e k l :
  pair_holds (Pair a (Some la) n1 k1) -> pair_holds (Pair b None n2 k2) ->
  multiplies h a b = true -> error_holds e h -> multiplies k la b = true -> adds l k e = true ->
  let k1b := times k1 (head k2 n2) in
  let t := (bump k1b + times (head k1 n1) (head k2 n2))%N in
  pair_holds (Pair h (Some l) (product_error n1 n2 + k1b + t) (bump t)).
Proof.
  intros A B T E K L k1b t. destruct (product_of _ _ _ _ A B T E) as (N & D & X & M & Fe & Xe & Mh). simpl in *.
  assert (Hb := pair_head _ B). simpl in Hb. assert (Ma := magnitude_pos _ A). assert (Mb := magnitude_pos _ B).
  simpl in Ma, Mb. destruct A as (Za & _ & La & _). simpl in Za, La.
  apply multiplies_true in K as (_ & _ & Xk & _ & Rk).
  assert (Lk := low_head _ _ _ _ _ _ Ma Mb La Hb). fold k1b in Lk. rewrite <- Mh in Lk.
  destruct (low_rounded _ _ _ _ M Lk Rk) as (N1 & L1).
  apply product_end with e k; try assumption.
  - destruct E as (E & _). lra.
  - rewrite Xk, Za. ring.
  - replace (f h + f e + f k - x h) with ((f a + f la) * (f b + 0) - x h + (f k - f la * f b)) by (rewrite Fe; ring).
    now apply near_add.
Qed.

Lemma product_with_both a la n1 k1 b lb n2 k2 h e c1 c2 k l y y_size missing :
  pair_holds (Pair a (Some la) n1 k1) -> pair_holds (Pair b (Some lb) n2 k2) ->
  multiplies h a b = true -> error_holds e h -> multiplies c1 a lb = true -> multiplies c2 la y = true ->
  adds k c1 c2 = true -> adds l k e = true ->
  Rabs (f y) <= c y_size * m b -> near missing (m h) (f la * (f y - (f b + f lb))) ->
  let s1 := times (head k1 n1) k2 in
  let s2 := times k1 y_size in
  let s3 := (bump s1 + bump s2)%N in
  let t := (bump s3 + times (head k1 n1) (head k2 n2))%N in
  pair_holds (Pair h (Some l) (product_error n1 n2 + missing + s1 + s2 + s3 + t) (bump t)).
Proof.
  intros A B T E K1 K2 K L Y Miss s1 s2 s3 t.
  destruct (product_of _ _ _ _ A B T E) as (N & D & X & M & Fe & Xe & Mh). simpl in *.
  assert (Ha := pair_head _ A). simpl in Ha. assert (Ma := magnitude_pos _ A). assert (Mb := magnitude_pos _ B).
  simpl in Ma, Mb. destruct A as (Za & _ & La & _). destruct B as (Zb & _ & Lb & _). simpl in Za, La, Zb, Lb.
  apply multiplies_true in K1 as (_ & _ & Xk1 & _ & Rk1). apply multiplies_true in K2 as (_ & _ & Xk2 & _ & Rk2).
  apply adds_true in K as (_ & _ & Xk & _ & Rk).
  assert (L1 := head_low _ _ _ _ _ _ Ma Mb Ha Lb). fold s1 in L1. rewrite <- Mh in L1.
  assert (L2 := low_head _ _ _ _ _ _ Ma Mb La Y). fold s2 in L2. rewrite <- Mh in L2.
  destruct (low_rounded _ _ _ _ M L1 Rk1) as (N1 & B1). destruct (low_rounded _ _ _ _ M L2 Rk2) as (N2 & B2).
  destruct (low_rounded _ _ _ _ M (low_add _ _ _ _ _ B1 B2) Rk) as (N3 & B3). fold s3 in N3, B3.
  apply product_end with e k; try assumption.
  - destruct E as (E & _). lra.
  - rewrite Xk, Xk1, Xk2, Za, Zb. ring.
  - replace (f h + f e + f k - x h) with ((f a + f la) * (f b + f lb) - x h + f la * (f y - (f b + f lb))
      + (f c1 - f a * f lb) + (f c2 - f la * f y) + (f k - (f c1 + f c2))) by (rewrite Fe; ring).
    apply near_add; [apply near_add; [apply near_add; [apply near_add|]|]|]; assumption.
Qed.

(** *** Factors *)

Lemma deviation_next k t : deviation x m (k + 1) t = deviation x m k t + u.
Proof. unfold deviation. rewrite roundings_add. change (roundings 1) with 1. ring. Qed.

Lemma round_factor v k t y z :
  (not_zero x t -> deviation x m k t < 1 -> exists p, z = y * p /\ factor (deviation x m k t) p) ->
  rounds z (f v) -> x v = y -> factor_holds v (k + 1) t.
Proof.
  intros H R X Z D. positive_u. rewrite deviation_next in *. assert (P := deviation_pos x m k t).
  destruct (H Z) as (p & -> & Fp); [lra|]. destruct (factor_rounds _ _ R) as (q & Fv & Fq).
  exists (p * q). split; [rewrite Fv, X; ring|]. apply factor_mul; try assumption; lra.
Qed.

Lemma total_single h n : total x m (single h n) = c n * (u * u) * kappa x m h.
Proof.
  unfold single. destruct (N.eqb_spec n 0) as [-> | _]; simpl; [rewrite c_0|]; ring.
Qed.

Lemma not_zero_single h n : not_zero x (single h n) -> n <> 0%N -> x h <> 0.
Proof.
  unfold single. destruct (N.eqb_spec n 0) as [-> | _]; intros H N; [now elim N|]. now inversion H.
Qed.

Lemma rounded_pair v h l n k :
  pair_holds (Pair h (Some l) n k) -> adds v h l = true -> factor_holds v 1 (single h n).
Proof.
  intros (Z & N & _ & _) T. simpl in *. apply adds_true in T as (_ & _ & X & _ & R).
  apply (round_factor v 0 _ (x h) (f h + f l)); try assumption; [|lra].
  intros H D. unfold deviation in *. rewrite total_single in *. change (roundings 0) with 0 in *.
  rewrite Rmult_0_l, Rplus_0_l in *. apply pair_factor; try assumption. now apply not_zero_single.
Qed.

Lemma rounded_sum v h r n k :
  sum_holds (Pair h (Some r) n k) -> adds v h r = true -> factor_holds v 2 (single h (bump n + k)).
Proof.
  intros (Z & R0 & N & L & _) T. simpl in *. apply adds_true in T as (_ & _ & X & _ & R).
  apply (round_factor v 1 _ (x h) (f h + f r)); try assumption; [|lra].
  intros H D. unfold deviation in *. rewrite total_single in *. change (roundings 1) with 1 in *.
  rewrite Rmult_1_l in *. apply rest_factor with (before_rounding h); try assumption. now apply not_zero_single.
Qed.

Lemma rounded_exact_sum h n k : sum_holds (Pair h None n k) -> factor_holds h 1 (single h (bump n + k)).
Proof.
  intros (_ & R & N & L & _). simpl in *. intros H D. unfold deviation in *. rewrite total_single in *.
  change (roundings 1) with 1 in *. rewrite Rmult_1_l in *. rewrite <- (Rplus_0_r (f h)).
  apply rest_factor with (before_rounding h); try assumption. now apply not_zero_single.
Qed.

Lemma deviation_merge k1 k2 t1 t2 :
  deviation x m (k1 + k2) (merge t1 t2) = deviation x m k1 t1 + deviation x m k2 t2.
Proof. unfold deviation. rewrite roundings_add, total_merge. ring. Qed.

Lemma factor_of_product v a b k1 t1 k2 t2 :
  operation_of v = Some (Mul a b) -> factor_holds a k1 t1 -> factor_holds b k2 t2 ->
  factor_holds v (k1 + k2 + 1) (merge t1 t2).
Proof.
  intros O A B. assert (F := f_value _ _ O). assert (X := x_value _ _ O). assert (G := f_regular _ _ O). simpl in *.
  apply (round_factor v _ _ (x a * x b) (f a * f b)); [|rewrite F; now apply rounds_normal | exact X].
  intros Z D. apply not_zero_merge in Z as (Z1 & Z2). rewrite deviation_merge in *.
  assert (P1 := deviation_pos x m k1 t1). assert (P2 := deviation_pos x m k2 t2).
  destruct (A Z1) as (p & -> & Fp); [lra|]. destruct (B Z2) as (q & -> & Fq); [lra|].
  exists (p * q). split; [ring | now apply factor_mul].
Qed.

Lemma factor_of_quotient v a b k1 t1 k2 t2 :
  operation_of v = Some (Div a b) -> factor_holds a k1 t1 -> factor_holds b k2 t2 ->
  factor_holds v (k1 + k2 + 1) (merge t1 t2).
Proof.
  intros O A B. assert (F := f_value _ _ O). assert (X := x_value _ _ O).
  assert (G := f_regular _ _ O). assert (Xb := x_divisor _ _ _ O). simpl in *.
  apply (round_factor v _ _ (x a / x b) (f a / f b)); [|rewrite F; now apply rounds_normal | exact X].
  intros Z D. apply not_zero_merge in Z as (Z1 & Z2). rewrite deviation_merge in *.
  assert (P1 := deviation_pos x m k1 t1). assert (P2 := deviation_pos x m k2 t2).
  destruct (A Z1) as (p & -> & Fp); [lra|]. destruct (B Z2) as (q & -> & Fq); [lra|].
  assert (D2 : deviation x m k2 t2 < 1) by lra. assert (Q := factor_pos _ _ D2 Fq).
  exists (p * / q). split; [field; split; lra|]. apply factor_mul; try assumption. apply factor_inv; [lra | exact Fq].
Qed.

Lemma factor_of_negative v a k t : operation_of v = Some (Neg a) -> factor_holds a k t -> factor_holds v k t.
Proof.
  intros O A Z D. assert (N : negates v a = true) by (unfold negates; rewrite O; apply Pos.eqb_refl).
  apply negates_true in N as (F & X & _). destruct (A Z D) as (p & E & P). exists p. split; [|exact P].
  rewrite F, X, E. ring.
Qed.

Lemma deviation_le k k' t t' : (k <= k')%N -> contained t t' = true -> deviation x m k t <= deviation x m k' t'.
Proof.
  intros K T. unfold deviation. apply roundings_le in K. apply (contained_total x m) in T. positive_u. nra.
Qed.

Lemma mean v a b k k1 k2 t t1 t2 :
  operation_of v = Some (Add a b) -> factor_holds a k1 t1 -> factor_holds b k2 t2 -> 0 <= x a -> 0 <= x b ->
  (k1 <= k)%N -> (k2 <= k)%N -> contained t1 t = true -> contained t2 t = true -> factor_holds v (k + 1) t.
Proof.
  intros O A B Pa Pb K1 K2 T1 T2. assert (T : adds v a b = true).
  { unfold adds. rewrite O, !Pos.eqb_refl. reflexivity. }
  apply adds_true in T as (_ & _ & X & _ & R).
  apply (round_factor v _ _ (x a + x b) (f a + f b)); try assumption. intros Z D.
  assert (D1 := deviation_le _ _ _ _ K1 T1). assert (D2 := deviation_le _ _ _ _ K2 T2).
  destruct (A (contained_not_zero _ _ _ T1 Z)) as (p & -> & Fp); [lra|].
  destruct (B (contained_not_zero _ _ _ T2 Z)) as (q & -> & Fq); [lra|].
  apply factor_mean; try assumption.
  - apply deviation_pos.
  - exact (factor_le _ _ _ (deviation_pos _ _ _ _) D1 D Fp).
  - exact (factor_le _ _ _ (deviation_pos _ _ _ _) D2 D Fq).
Qed.

Lemma zero_of v a b :
  operation_of v = Some (Mul a b) \/ operation_of v = Some (Div a b) -> is_zero_constant a = true ->
  f v = 0 /\ x v = 0 /\ m v = 0.
Proof.
  intros O H. unfold is_zero_constant in H. destruct (operation_of a) as [[| [] | | | | | | |]|] eqn:E; try discriminate.
  assert (Fa := f_value _ _ E). assert (Xa := x_value _ _ E). assert (Ma := m_value _ _ E). simpl in *.
  rewrite RN_float in Fa by apply float_0. rewrite Rabs_R0 in Ma.
  destruct O as [O | O]; assert (F := f_value _ _ O); assert (X := x_value _ _ O); assert (M := m_value _ _ O); simpl in *;
    rewrite F, X, M, Fa, Xa, Ma; unfold Rdiv; rewrite !Rmult_0_l; (split; [apply RN_float, float_0 | now split]).
Qed.

Lemma zero_sum s v a b :
  sound s -> operation_of v = Some (Add a b) -> is_zero s a && is_zero s b = true -> f v = 0 /\ x v = 0 /\ m v = 0.
Proof.
  intros S O H. apply andb_prop in H as [A B]. apply is_zero_true in A as (Fa & Xa & Ma), B as (Fb & Xb & Mb); try exact S.
  assert (F := f_value _ _ O). assert (X := x_value _ _ O). assert (M := m_value _ _ O). simpl in *.
  rewrite F, X, M, Fa, Fb, Xa, Xb, Ma, Mb, Rplus_0_r. split; [apply RN_float, float_0 | now split].
Qed.

Lemma plus_zero v a z k t :
  f z = 0 /\ x z = 0 /\ m z = 0 -> factor_holds a k t -> adds v a z || subtracts v z a = true -> factor_holds v k t.
Proof.
  intros (Fz & Xz & _) A T Z D. destruct (A Z D) as (p & E & P). exists p. split; [|exact P].
  apply orb_prop in T as [T | T]; [apply adds_true in T as (_ & F & X & _) | apply subtracts_true in T as (_ & F & X & _)].
  - rewrite F, X, Fz, Xz, !Rplus_0_r, RN_float by apply f_float. exact E.
  - rewrite F, X, Fz, Xz, E. replace (0 - x a * p) with (- f a) by (rewrite E; ring).
    rewrite RN_opp, RN_float, E by apply f_float. ring.
Qed.

(** *** Quotients *)

Lemma rounds_exact v : rounds v v.
Proof.
  exists 0. rewrite Rabs_R0. positive_u. split; [|ring]. apply Rmult_le_pos; [lra|].
  apply Rlt_le, Rinv_0_lt_compat. lra.
Qed.

Lemma separated s y l v h r n k :
  sound s -> pair_holds (Pair h (Some r) n k) -> joins y h r = true ->
  match v with
  | None => is_error s l y = true -> pair_holds (Pair y (Some l) n (one + tiny n))
  | Some v => subtracts v y h && subtracts l r v = true ->
      pair_holds (Pair y (Some l) (separated_error k n) (separated_rest k n))
  end /\ factor_holds y 1 (single y n).
Proof.
  intros S (Zr & N & L & X) J. simpl in *. assert (M : 0 <= m h) by (assert (P := Rabs_pos (x h)); lra).
  destruct (joins_true _ _ _ J) as (Xy & My & R). rewrite Zr, Rplus_0_r in Xy.
  assert (B : before_rounding y = f h + f r).
  { unfold joins in J. destruct (operation_of y) as [[]|] eqn:E; try discriminate. apply andb_prop in J as [J1 J2].
    apply Pos.eqb_eq in J1, J2. subst. now rewrite (before _ _ E). }
  split.
  - destruct v as [v|]; intros T.
    + apply andb_prop in T as [T1 T2]. apply subtracts_true in T1 as (_ & _ & Xv & _ & Rv).
      apply subtracts_true in T2 as (_ & _ & Xl & _ & Rl).
      destruct (separated_fast _ _ _ _ _ _ _ _ _ M X N L R Rv Rl) as (A & C).
      repeat split; simpl; rewrite ?My, ?Xy; try assumption. lra.
    + apply is_error_true in T as (Fl & Xl); [|exact S]. rewrite B in Fl.
      destruct (separated_exact _ _ _ _ _ _ _ M X N R Fl) as (A & C).
      repeat split; simpl; rewrite ?My, ?Xy; assumption.
  - apply (round_factor y 0 _ (x y) (f h + f r)); try assumption; [|reflexivity].
    intros H D. unfold deviation in *. rewrite total_single in *. change (roundings 0) with 0 in *.
    rewrite Rmult_0_l, Rplus_0_l in *. unfold kappa in *. apply pair_factor; try assumption.
    + now apply not_zero_single.
    + now rewrite Xy, My.
Qed.

Lemma divisor_holds s y k g :
  sound s -> 0 <= m y -> divisor_of s y = Some (k, g) ->
  let t := c g * (u * u) * kappa x m y in
  0 <= t /\ t * Rabs (x y) <= c g * (u * u) * m y /\ roundings k * u + t <= 1 / 1024
  /\ exists r, f y = x y * r /\ factor (roundings k * u + t) r.
Proof.
  intros S M H t. positive_u. assert (P := c_pos g). assert (K : 0 <= kappa x m y) by apply Rabs_pos.
  assert (T0 : 0 <= t) by (apply Rmult_le_pos; [nra | exact K]).
  assert (exists ts, factor_of s y = Some (k, ts) /\ total x m ts = t /\ (not_zero x [(y, g)] -> not_zero x ts) /\
    existsb (fun d => Pos.eqb (fst d) y && (1024 * k <=? fst (snd d))%N && contained (single y (1024 * g)) (snd (snd d)))
      divisors = true) as (ts & F & E & Z & G).
  { unfold divisor_of in H. destruct (factor_of s y) as [[k' [|[j g'] [|]]]|] eqn:F; try discriminate.
    - apply guard_true in H as [H E]. injection E as -> <-. exists []. split; [reflexivity|]. split; [|split; [constructor | exact H]].
      unfold t. rewrite c_0. simpl. ring.
    - destruct (Pos.eqb_spec j y) as [-> | _]; [|discriminate]. apply guard_true in H as [H E]. injection E as -> ->.
      exists [(y, g)]. split; [reflexivity|]. split; [simpl; unfold t; ring | split; [auto | exact H]]. }
  apply existsb_exists in G as (d & I & G). apply andb_prop in G as [G G3]. apply andb_prop in G as [G1 G2].
  apply Pos.eqb_eq in G1. apply N.leb_le, roundings_le in G2. assert (W := x_determined).
  rewrite Forall_forall in W. destruct (W d I) as (X & _ & D). rewrite G1 in X.
  apply (contained_total x m) in G3. rewrite total_single in G3. unfold deviation in D.
  assert (K1 : roundings (1024 * k) = 1024 * roundings k) by (unfold roundings; rewrite N2Z.inj_mul, mult_IZR; reflexivity).
  assert (K2 : c (1024 * g) = 1024 * c g) by (rewrite !c_value, N2Z.inj_mul, mult_IZR; simpl; lra).
  rewrite K1 in G2. rewrite K2 in G3.
  assert (D' : roundings k * u + t <= 1 / 1024).
  { unfold t. assert (1024 * roundings k * u <= roundings (fst (snd d)) * u) by (apply Rmult_le_compat_r; lra). lra. }
  split; [exact T0|]. split; [|split; [exact D'|]].
  - assert (O : kappa x m y * Rabs (x y) = m y).
    { unfold kappa. rewrite <- Rabs_mult. replace (m y / x y * x y) with (m y) by (field; exact X). apply Rabs_right. lra. }
    right. unfold t. now rewrite Rmult_assoc, O.
  - assert (Q := factor_of_holds _ _ _ _ S F). unfold factor_holds, deviation in Q. rewrite E in Q. apply Q; [|lra].
    apply Z. constructor; [exact X | constructor].
Qed.

Lemma quotient_magnitude a b ma mb : Rabs a <= ma -> Rabs b <= mb -> b <> 0 -> Rabs (a / b) <= ma * mb / (b * b).
Proof.
  intros A B Z. assert (P := Rabs_pos_lt b Z). assert (I := Rinv_0_lt_compat _ P). unfold Rdiv. rewrite Rabs_mult, Rabs_inv.
  assert (b * b = Rabs b * Rabs b) as -> by (rewrite <- Rabs_mult, Rabs_right; [reflexivity | nra]).
  replace (ma * mb * / (Rabs b * Rabs b)) with (ma * / Rabs b * (mb * / Rabs b)) by (field; lra).
  assert (1 <= mb * / Rabs b) by (apply Rmult_le_reg_r with (Rabs b); [exact P | rewrite Rmult_assoc, Rinv_l; lra]).
  assert (0 <= Rabs a) by apply Rabs_pos. apply Rle_trans with (ma * / Rabs b * 1); [nra|]. apply Rmult_le_compat_l; nra.
Qed.

Lemma quotient s q a la n1 k1 b lb n2 k2 p e s1 s2 divisor dividend l k g :
  sound s -> pair_holds (Pair a la n1 k1) -> pair_holds (Pair b lb n2 k2) -> divisor_of s b = Some (k, g) ->
  divides q a b = true -> multiplies p q b = true -> is_error s e p = true -> subtracts s1 a p = true ->
  subtracts s2 s1 e = true ->
  let s3 := match divisor with Some (_, i) => i | None => s2 end in
  let s4 := match dividend with Some i => i | None => s3 end in
  match lb, divisor with
  | Some lb, Some (w, i) => multiplies w q lb && subtracts i s2 w
  | None, None => true
  | _, _ => false
  end = true ->
  match la, dividend with Some la, Some i => adds i s3 la | None, None => true | _, _ => false end = true ->
  divides l s4 b = true ->
  pair_holds (Pair q (Some l) (quotient_error n1 k1 n2 k2 k g) (quotient_rest n1 k1 k2)).
Proof.
  intros S A B G Q P E T1 T2 s3 s4 T3 T4 T5.
  assert (Mb := magnitude_pos _ B). simpl in Mb. destruct (divisor_holds _ _ _ _ S Mb G) as (G1 & G2 & G3 & r & G4 & G5).
  destruct A as (Za & Na & La & Xa). destruct B as (Zb & Nb & Lb & Xb). simpl in *.
  apply divides_true in Q as (Z & Xq & Mq & Rq). apply multiplies_true in P as (Bp & _ & Xp & _ & Rp).
  apply is_error_true in E as (Fe & Xe); [|exact S]. rewrite Bp in Fe.
  apply subtracts_true in T1 as (_ & _ & X1 & _ & R1). apply subtracts_true in T2 as (_ & _ & X2 & _ & R2).
  rewrite Fe in R2. apply divides_true in T5 as (_ & Xl & _ & Rl).
  assert (W : exists w, rounds (f q * partial f lb) w /\ rounds (f s2 - w) (f s3) /\ x s3 = x s2).
  { unfold s3. destruct lb as [lb|], divisor as [[w i]|]; try discriminate; simpl in *.
    - apply andb_prop in T3 as [T3 T6]. apply multiplies_true in T3 as (_ & _ & Xw & _ & Rw).
      apply subtracts_true in T6 as (_ & _ & Xi & _ & Ri). exists (f w). repeat split; try assumption.
      rewrite Xi, Xw, Zb. ring.
    - exists 0. rewrite Rmult_0_r, Rminus_0_r. repeat split; apply rounds_exact. }
  destruct W as (w & W1 & W2 & W3).
  assert (V : rounds (f s3 + partial f la) (f s4) /\ x s4 = x s3).
  { unfold s4. destruct la as [la|], dividend as [i|]; try discriminate; simpl in *.
    - apply adds_true in T4 as (_ & _ & Xi & _ & Ri). split; [exact Ri | rewrite Xi, Za; ring].
    - rewrite Rplus_0_r. split; [apply rounds_exact | reflexivity]. }
  destruct V as (V1 & V2).
  destruct (quotient_holds n1 k1 n2 k2 k g _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ Xa Xb Z Na La Nb Lb G1 G2 G3 r G4 G5
    Rq Rp R1 R2 W1 W2 V1 Rl) as (H1 & H2).
  rewrite <- Xq, <- Mq in *. repeat split; simpl; try assumption.
  - rewrite Xl, V2, W3, X2, X1, Xp, Xe, Xq. field. exact Z.
  - rewrite Mq, Xq. now apply quotient_magnitude.
Qed.

(** *** Every step keeps what is known true *)

Lemma step_sound s k s' : sound s -> step s k = Some s' -> sound s'.
Proof.
  intros S H. destruct k; simpl in H.
  - apply guard_true in H as [T <-]. apply add_error; [exact S|]. now apply error_of_sum in T.
  - apply guard_true in H as [T <-]. apply add_error; [exact S|]. now apply error_of_difference in T.
  - apply guard_true in H as [T <-]. apply add_error; [exact S|]. now apply error_of_product in T.
  - destruct (pair_of s a) as [p|] eqn:A; [|discriminate]. destruct (pair_of s b) as [q|] eqn:B; [|discriminate].
    destruct (adds h (first p) (first q) && negb (is_joined h)) eqn:T; [|discriminate].
    destruct (rest_of_sum _ _ h p q r) as [sum|] eqn:R; [|discriminate]. injection H as <-.
    apply andb_prop in T as [T J]. apply negb_true_iff in J.
    apply add_sum; [exact S|]. apply adds_true in T as (Bh & _ & X & M & Rh). specialize (M J).
    refine (signed_sum 1 h p q r sum _ _ (or_introl eq_refl) (pair_of_holds _ _ _ S A) (pair_of_holds _ _ _ S B)
      _ _ M _ _ _ R).
    + now rewrite Rmult_1_l.
    + now rewrite Rmult_1_l.
    + now rewrite Bh.
    + intros t i j Y. apply adds_true in Y as (_ & _ & X' & _ & R'). now rewrite !Rmult_1_l.
    + intros t i Y. apply Pos.eqb_eq in Y. subst. now rewrite !Rmult_1_l.
  - destruct (pair_of s a) as [p|] eqn:A; [|discriminate]. destruct (pair_of s b) as [q|] eqn:B; [|discriminate].
    destruct (subtracts h (first p) (first q)) eqn:T; [|discriminate].
    destruct (rest_of_sum _ _ h p q r) as [sum|] eqn:R; [|discriminate]. injection H as <-.
    apply add_sum; [exact S|]. apply subtracts_true in T as (Bh & _ & X & M & Rh).
    refine (signed_sum (-1) h p q r sum _ _ (or_intror eq_refl) (pair_of_holds _ _ _ S A) (pair_of_holds _ _ _ S B)
      _ _ M _ _ _ R).
    + rewrite Bh. ring.
    + rewrite X. ring.
    + now rewrite Bh.
    + intros t i j Y. apply subtracts_true in Y as (_ & _ & X' & _ & R'). split; [rewrite X'; ring|].
      replace (f i + -1 * f j) with (f i - f j) by ring. exact R'.
    + intros t i Y. apply negates_true in Y as (F' & X' & _). split; [rewrite F' | rewrite X']; ring.
  - destruct (PositiveMap.find sum (sums s)) as [[h r n k]|] eqn:E; [|discriminate]. apply (sound_sums _ S) in E.
    destruct r as [r|], l as [l|]; try discriminate; apply guard_true in H as [T <-].
    + apply andb_prop in T as [T1 T2]. apply add_pair; [exact S|]. apply low_of_sum with r e; try assumption.
      now apply is_error_true with s.
    + apply add_pair; [exact S|]. apply low_of_exact_sum; [exact E|]. now apply is_error_true with s.
  - destruct (pair_of s a) as [[a' [la|] n1 k1]|] eqn:A; try discriminate.
    destruct (pair_of s b) as [[b' [lb|] n2 k2]|] eqn:B; try discriminate.
    apply guard_true in H as [T <-]. apply andb_prop in T as [T1 T2]. apply add_pair; [exact S|].
    apply pair_of_holds in A, B; try assumption. apply is_error_true in T2; [|exact S].
    destruct (product_of _ _ _ _ A B T1 T2) as (N & D & X & M & Fe & Xe & Mh). simpl in *.
    repeat split; simpl; try assumption.
    replace (f h + f e - x h) with ((f a' + 0) * (f b' + 0) - x h) by (rewrite Fe; ring). exact N.
  - destruct (pair_of s a) as [[a' [la|] n1 k1]|] eqn:A; try discriminate.
    destruct (pair_of s b) as [[b' [lb|] n2 k2]|] eqn:B; try discriminate.
    apply guard_true in H as [T <-]. tests T. apply add_pair; [exact S|].
    apply pair_of_holds in A, B; try assumption. apply is_error_true in T2; [|exact S].
    now apply product_with_one with a' la b' e k.
  - destruct (pair_of s a) as [[a' [la|] n1 k1]|] eqn:A; try discriminate.
    destruct (pair_of s b) as [[b' [lb|] n2 k2]|] eqn:B; try discriminate.
    apply pair_of_holds in A, B; try assumption.
    assert (Ma := magnitude_pos _ A). assert (Mb := magnitude_pos _ B). simpl in Ma, Mb.
    destruct partner as [y|]; apply guard_true in H as [T <-]; tests T; apply add_pair; try exact S;
      apply is_error_true in T5; try exact S.
    + assert (N : Rabs (f b' + f lb) <= c (one + tiny n2) * m b').
      { destruct B as (_ & N & _ & X). simpl in *. replace (f b' + f lb) with (x b' + (f b' + f lb - x b')) by ring.
        apply Rle_trans with (1 := Rabs_triang _ _). rewrite c_add, c_one.
        assert (G := tiny_near n2 (m b') Mb). unfold near in N. lra. }
      apply adds_true in T0 as (_ & _ & _ & _ & Ry).
      apply product_with_both with a' la b' lb e c1 c2 k y; try assumption.
      * assert (E := rounds_error _ _ Ry). replace (f y) with ((f b' + f lb) + (f y - (f b' + f lb))) by ring.
        apply Rle_trans with (1 := Rabs_triang _ _). positive_u.
        apply Rle_trans with (c (one + tiny n2) * (1 + u) * m b').
        -- assert (Q := Rabs_pos (f b' + f lb)). nra.
        -- apply scale; [apply c_bump | exact Mb].
      * destruct (product_of _ _ _ _ A B T T5) as (_ & _ & _ & _ & _ & _ & Mh). simpl in Mh. rewrite Mh.
        destruct A as (_ & _ & La & _). simpl in La. apply low_low; try assumption.
        replace (f y - (f b' + f lb)) with (- ((f b' + f lb) - f y)) by ring. apply low_opp. now apply error_low.
    + apply product_with_both with a' la b' lb e c1 c2 k b'; try assumption.
      * now apply (pair_head _ B).
      * destruct (product_of _ _ _ _ A B T T5) as (_ & _ & _ & _ & _ & _ & Mh). simpl in Mh. rewrite Mh.
        destruct A as (_ & _ & La & _). destruct B as (_ & _ & Lb & _). simpl in La, Lb. apply low_low; try assumption.
        replace (f b' - (f b' + f lb)) with (- f lb) by ring. now apply low_opp.
  - destruct (PositiveMap.find pair0 (pairs s)) as [[h [r|] n k]|] eqn:E; try discriminate.
    apply (sound_pairs _ S) in E. destruct v as [v|]; apply guard_true in H as [T <-]; apply andb_prop in T as [J T].
    + destruct (separated s y l (Some v) h r n k S E J) as (A & B). apply add_factor; [|exact B].
      apply add_pair; [exact S | now apply A].
    + destruct (separated s y l None h r n k S E J) as (A & B). apply add_factor; [|exact B].
      apply add_pair; [exact S | now apply A].
  - destruct (pair_of s a) as [[a' la n1 k1]|] eqn:A; [|discriminate].
    destruct (pair_of s b) as [[b' lb n2 k2]|] eqn:B; [|discriminate].
    destruct (divisor_of s b') as [[k g]|] eqn:G; [|discriminate].
    apply guard_true in H as [T <-]. tests T. apply add_pair; [exact S|]. apply pair_of_holds in A, B; try assumption.
    now apply quotient with s a' la b' lb p e s1 s2 divisor dividend.
  - destruct (PositiveMap.find a (pairs s)) as [[p [la|] n k]|] eqn:E; try discriminate.
    apply guard_true in H as [T <-]. apply andb_prop in T as [T1 T2]. apply add_pair; [exact S|].
    apply (sound_pairs _ S) in E. destruct E as (Z & N & L & X). simpl in *.
    apply negates_true in T1 as (F1 & X1 & M1). apply negates_true in T2 as (F2 & X2 & _).
    repeat split; simpl; rewrite ?M1, ?F1, ?F2, ?X1, ?X2.
    + rewrite Z. ring.
    + replace (- f p + - f la - - x p) with (- (f p + f la - x p)) by ring. now apply near_opp.
    + now apply low_opp.
    + now rewrite Rabs_Ropp.
  - destruct (PositiveMap.find id (pairs s)) as [[h [l|] n k]|] eqn:E; try discriminate.
    apply guard_true in H as [T <-]. apply add_factor; [exact S|]. apply (sound_pairs _ S) in E.
    now apply rounded_pair with l k.
  - destruct (PositiveMap.find id (sums s)) as [[h [r|] n k]|] eqn:E; try discriminate;
    apply guard_true in H as [T <-]; (apply add_factor; [exact S|]); apply (sound_sums _ S) in E.
    + now apply rounded_sum with r.
    + apply Pos.eqb_eq in T. subst. now apply rounded_exact_sum.
  - destruct (operation_of v) as [[| | a | | | | a b | a b |]|] eqn:O; try discriminate.
    + destruct (factor_of s a) as [[k t]|] eqn:A; [|discriminate]. injection H as <-. apply add_factor; [exact S|].
      apply factor_of_negative with a; [exact O|]. now apply factor_of_holds with s.
    + destruct (factor_of s a) as [[k1 t1]|] eqn:A; [|discriminate].
      destruct (factor_of s b) as [[k2 t2]|] eqn:B; [|discriminate]. injection H as <-. apply add_factor; [exact S|].
      apply factor_of_product with a b; [exact O| |]; now apply factor_of_holds with s.
    + destruct (factor_of s a) as [[k1 t1]|] eqn:A; [|discriminate].
      destruct (factor_of s b) as [[k2 t2]|] eqn:B; [|discriminate]. injection H as <-. apply add_factor; [exact S|].
      apply factor_of_quotient with a b; [exact O| |]; now apply factor_of_holds with s.
  - destruct (operation_of v) as [[| | | a b | | | | |]|] eqn:O; try discriminate.
    destruct (factor_of s a) as [[k1 t1]|] eqn:A; [|discriminate].
    destruct (factor_of s b) as [[k2 t2]|] eqn:B; [|discriminate].
    apply guard_true in H as [T <-]. tests T. apply add_factor; [exact S|].
    apply N.leb_le in T2, T3. apply zero_or_true in T, T4; try exact S.
    apply mean with a b k1 k2 t1 t2; try assumption; now apply factor_of_holds with s.
  - destruct (operation_of v) as [[| | | a b | | | a b | a b |]|] eqn:O; try discriminate; apply guard_true in H as [T <-];
      (apply add_zero; [exact S|]); [now apply zero_sum with s a b | |];
      (apply zero_of with a b; [|exact T]); [left | right]; exact O.
  - destruct (PositiveMap.find z (zeros s)) as [y|] eqn:Z; [|discriminate].
    destruct (factor_of s a) as [[k t]|] eqn:A; [|discriminate]. apply guard_true in H as [T <-].
    apply add_factor; [exact S|]. apply plus_zero with a z; try assumption.
    + now apply (sound_zeros _ S z y).
    + now apply factor_of_holds with s.
  - destruct (operation_of v) as [[| | | a b | | | a b | a b |]|] eqn:O; try discriminate;
    apply guard_true in H as [T <-]; (apply add_not_negative; [exact S|]); assert (X := x_value _ _ O); simpl in X;
    rewrite X.
    + apply andb_prop in T as [T1 T2]. apply zero_or_true in T1, T2; try exact S. lra.
    + apply orb_prop in T as [T | T].
      * apply Pos.eqb_eq in T. subst. nra.
      * apply andb_prop in T as [T1 T2]. apply zero_or_true in T1, T2; try exact S. nra.
    + apply andb_prop in T as [T1 T2]. apply zero_or_true in T1, T2; try exact S.
      assert (Xb := x_divisor _ _ _ O). apply Rmult_le_pos; [exact T1|].
      apply Rlt_le, Rinv_0_lt_compat. lra.
Qed.

Lemma follow_sound cert : forall s s', sound s -> follow s cert = Some s' -> sound s'.
Proof.
  induction cert as [|k cert IH]; simpl; intros s s' S H; [now injection H as <-|].
  destruct (step s k) as [s1|] eqn:E; [|discriminate]. apply (IH s1); [|exact H]. now apply step_sound with s k.
Qed.

Lemma no_facts_sound : sound no_facts.
Proof. constructor; simpl; intros i; intros; rewrite PositiveMap.gempty in *; discriminate. Qed.

Lemma factor_error v k t :
  factor_holds v k t -> not_zero x t -> deviation x m k t < 1 ->
  Rabs (f v - x v) <= deviation x m k t / (1 - deviation x m k t) * Rabs (x v).
Proof.
  intros H Z D. destruct (H Z D) as (p & -> & P). replace (x v * p - x v) with ((p - 1) * x v) by ring.
  rewrite Rabs_mult. apply scale; [now apply factor_bound | apply Rabs_pos].
Qed.

End Checking.

(** ** The checker *)

Definition table (p : program) : PositiveMap.t operation :=
  fold_right (fun named => PositiveMap.add (fst named) (snd named)) (PositiveMap.empty _) p.

Lemma table_in p : forall i o, PositiveMap.find i (table p) = Some o -> In (i, o) p.
Proof.
  induction p as [|[j k] p IH]; simpl; intros i o H.
  - rewrite PositiveMap.gempty in H. discriminate.
  - apply find_add in H as [[-> ->] | H]; auto.
Qed.

Definition claims (operations : PositiveMap.t operation) (s : facts) (b : bound) : bool :=
  match factor_of operations s (fst b) with
  | Some (k, t) => (k <=? fst (snd b))%N && contained t (snd (snd b))
  | None => false
  end.

Definition has_bound (divisors : list bound) (o : operation) : bool :=
  match o with Div _ b => existsb (fun d => Pos.eqb (fst d) b) divisors | _ => true end.

Definition check (p : program) (cert : list command) (bounds divisors : list bound) : bool :=
  well_formed 1 p && forallb (fun named => has_bound divisors (snd named)) p
  && match follow (table p) divisors no_facts cert with
     | Some s => forallb (claims (table p) s) (divisors ++ bounds)
     | None => false
     end.

(** What a bound says of the program: the computed result differs from the exact one by at most [t / (1 - t)] of it,
    where [t] is [k * u] and the sum of all [c * u^2 * kappa]. *)
Definition bounded (input : values) (p : program) (b : bound) : Prop :=
  let f := computed input p in
  let x := exact input p in
  let t := deviation x (magnitude input p) (fst (snd b)) (snd (snd b)) in
  applies input p b -> Rabs (f (fst b) - x (fst b)) <= t / (1 - t) * Rabs (x (fst b)).

Lemma check_well_formed p cert bounds divisors : check p cert bounds divisors = true -> well_formed 1 p = true.
Proof. unfold check. intros H. apply andb_prop in H as [H _]. now apply andb_prop in H. Qed.

Lemma check_divisors p cert bounds divisors :
  check p cert bounds divisors = true -> forall i a b, In (i, Div a b) p -> exists d, In d divisors /\ fst d = b.
Proof.
  unfold check. intros H i a b O. apply andb_prop in H as [H _]. apply andb_prop in H as [_ H]. rewrite forallb_forall in H.
  specialize (H _ O). apply existsb_exists in H as (d & I & E). apply Pos.eqb_eq in E. eauto.
Qed.

Lemma computed_value input p i o :
  well_formed 1 p = true -> In (i, o) p -> computed input p i = RN (value input (computed input p) o).
Proof. apply (run_value (fun e o => RN (value input e o)) p (local_rounded input)). Qed.

Lemma float_computed input p i : is_float (computed input p i).
Proof. apply run_float. intros j. apply float_0. Qed.

Theorem check_factors p cert bounds divisors :
  check p cert bounds divisors = true ->
  forall input, (forall k, is_float (input k)) -> all_regular input p -> Forall (determined input p) divisors ->
  Forall (fun b => factor_holds (computed input p) (exact input p) (magnitude input p) (fst b) (fst (snd b)) (snd (snd b)))
    (divisors ++ bounds).
Proof.
  intros H input I R Dv. assert (Divides := check_divisors _ _ _ _ H).
  unfold check in H. apply andb_prop in H as [H H']. apply andb_prop in H as [W _]. rename H' into H.
  destruct (follow (table p) divisors no_facts cert) as [s|] eqn:F; [|discriminate].
  assert (Values : forall i o, PositiveMap.find i (table p) = Some o -> In (i, o) p) by apply table_in.
  rewrite forallb_forall in H. apply Forall_forall. intros [v [k t]] B. specialize (H _ B).
  unfold claims in H. simpl in *. destruct (factor_of (table p) s v) as [[k' t']|] eqn:E; [|discriminate].
  apply andb_prop in H as [K T]. apply N.leb_le in K. intros Z D.
  assert (G : factor_holds (computed input p) (exact input p) (magnitude input p) v k' t').
  { refine (factor_of_holds (table p) input _ _ _ _ _ _ _ _ _ s v k' t'
      (follow_sound (table p) divisors input _ _ _ _ _ _ _ _ _ _ _ _ cert no_facts s (no_facts_sound _ _ _ _ _) F) E).
    all: try (intros i o O; apply Values in O).
    all: try exact I.
    all: try now apply computed_value.
    all: try now apply (run_value (value input) p (local_value input) 1).
    all: try now apply (run_value (size input (exact input p)) p (local_size input _) 1).
    all: try apply float_computed.
    all: try now apply float_constant, (well_formed_constant p 1 i o W).
    all: try exact Dv.
    all: try (intros i a b O; apply Values in O; destruct (Divides _ _ _ O) as (d & Id & <-);
      rewrite Forall_forall in Dv; apply (Dv d Id)).
    all: unfold all_regular in R; rewrite Forall_forall in R; exact (R _ O). }
  assert (L := deviation_le (exact input p) (magnitude input p) _ _ _ _ K T).
  destruct (G (contained_not_zero _ _ _ T Z)) as (q & Fq & Q); [lra|]. exists q. split; [exact Fq|].
  apply (factor_le _ _ _ (deviation_pos _ _ _ _) L D Q).
Qed.

Theorem check_sound p cert bounds divisors :
  check p cert bounds divisors = true ->
  forall input, (forall k, is_float (input k)) -> all_regular input p -> Forall (determined input p) divisors ->
  Forall (bounded input p) bounds.
Proof.
  intros H input I R D. assert (F := check_factors _ _ _ _ H input I R D). apply Forall_app in F as [_ F].
  refine (Forall_impl _ (fun b G A => _) F). destruct A as (Z & L). now apply factor_error.
Qed.
