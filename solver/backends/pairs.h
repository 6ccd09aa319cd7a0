/* Numbers of about twice the digits: each is the sum of two doubles, the second one what the first is rounded by.
 * The kernels' C, compiled as C++ with `Pair` for its numbers, rounds some thousand times finer than with `Lanes`.
 * The operations are those of T. Dekker 1971, doi:10.1007/BF01397083, but for what makes the second number as
 * small as it can be: it is no larger than some hundred roundings of the first. Functions are exact to 1e-19.
 *
 * Compiled after lanes.h. Like there, no lane looks at another and nothing is contracted.
 */
#ifndef STRIDEMAP_PAIRS_H
#define STRIDEMAP_PAIRS_H

#if defined(__AVX512F__) || (defined(__AVX2__) && defined(__FMA__))
#include <immintrin.h>
#endif

struct Pair {
    Vector hi, lo;

    Pair() = default;
    Pair(double x) : hi(Vector{} + x), lo(Vector{}) {}
    Pair(double x, double rest) : hi(Vector{} + x), lo(Vector{} + rest) {}
    Pair(Vector x) : hi(x), lo(Vector{}) {}
    Pair(Lanes x) : hi(x.v), lo(Vector{}) {}
    Pair(Vector hi, Vector lo) : hi(hi), lo(lo) {}

    Pair& operator+=(const Pair& y);
    Pair& operator-=(const Pair& y);
    Pair& operator*=(const Pair& y);
    Pair& operator/=(const Pair& y);

    explicit operator bool() const __attribute__((error("a branch on lanes")));
};

/* ---- sums and products without an error ---- */

static inline Pair exact_sum(Vector a, Vector b)
{
    const Vector s = a + b, t = s - a;
    return Pair(s, (a - (s - t)) + (b - t));
}
static inline Vector upper_half(Vector a)
{
    const Vector c = 134217729.0 * a; /* 2^27 + 1 */
    return c - (c - a);
}
/* The same two numbers with and without an instruction that rounds a product and a sum once. */
static inline Pair exact_product(Vector a, Vector b)
{
#if defined(__AVX512F__)
    const Vector product = a * b;
    return Pair(product, (Vector) _mm512_fmsub_pd((__m512d) a, (__m512d) b, (__m512d) product));
#elif defined(__AVX2__) && defined(__FMA__)
    const Vector product = a * b;
    return Pair(product, (Vector) _mm256_fmsub_pd((__m256d) a, (__m256d) b, (__m256d) product));
#else
    const Vector p = a * b, a1 = upper_half(a), b1 = upper_half(b), a2 = a - a1, b2 = b - b1;
    return Pair(p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2);
#endif
}

/* ---- arithmetic ---- */

static inline Pair operator-(const Pair& a) { return Pair(-a.hi, -a.lo); }
static inline Pair operator+(const Pair& a, const Pair& b)
{
    const Pair s = exact_sum(a.hi, b.hi);
    return Pair(s.hi, s.lo + (a.lo + b.lo));
}
static inline Pair operator-(const Pair& a, const Pair& b) { return a + (-b); }
static inline Pair operator*(const Pair& a, const Pair& b)
{
    const Pair p = exact_product(a.hi, b.hi);
    return Pair(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}
static inline Vector rounded(const Pair& a) { return a.hi + a.lo; }
static inline Pair operator/(const Pair& a, const Pair& b)
{
    const Vector first = a.hi / b.hi;
    return Pair(first, rounded(a - Pair(first) * b) / b.hi);
}

/* The same number, the second part as small as it can be. */
static inline Pair tidy(const Pair& a)
{
    const Vector s = a.hi + a.lo;
    return Pair(s, a.lo - (s - a.hi));
}

inline Pair& Pair::operator+=(const Pair& y) { return *this = *this + y; }
inline Pair& Pair::operator-=(const Pair& y) { return *this = *this - y; }
inline Pair& Pair::operator*=(const Pair& y) { return *this = *this * y; }
inline Pair& Pair::operator/=(const Pair& y) { return *this = *this / y; }

/* Comparisons are 1 or 0, as in C. */
static inline Pair operator<(const Pair& a, const Pair& b) { return truth(rounded(a - b) < 0.0); }
static inline Pair operator<=(const Pair& a, const Pair& b) { return truth(rounded(a - b) <= 0.0); }
static inline Pair operator>(const Pair& a, const Pair& b) { return truth(rounded(a - b) > 0.0); }
static inline Pair operator>=(const Pair& a, const Pair& b) { return truth(rounded(a - b) >= 0.0); }
static inline Pair operator==(const Pair& a, const Pair& b) { return truth(rounded(a - b) == 0.0); }
static inline Pair operator!=(const Pair& a, const Pair& b) { return truth(rounded(a - b) != 0.0); }

static inline Pair chosen(Words mask, const Pair& yes, const Pair& no)
{
    return Pair((Vector) where_else(mask, (Words) yes.hi, (Words) no.hi),
        (Vector) where_else(mask, (Words) yes.lo, (Words) no.lo));
}
static inline Pair fabs(const Pair& a) { return chosen(rounded(a) < 0.0, -a, a); }
static inline Pair fmax(const Pair& a, const Pair& b) { return chosen(rounded(a - b) >= 0.0, a, b); }
static inline Pair times_power(const Pair& a, double power_of_two) { return Pair(a.hi * power_of_two, a.lo * power_of_two); }

static inline Pair sqrt(const Pair& a)
{
    const Vector root = sqrt(Lanes(rounded(a))).v;
    return chosen(root == 0.0, a, Pair(root, 0.5 * rounded(a - exact_product(root, root)) / root));
}

/* ---- sine and cosine ----
 *
 * Within half a quarter turn by their series, whose later terms matter so little that doubles will do. */

static inline void sine_and_cosine(const Pair& x, Pair& sine, Pair& cosine, Words& quadrant)
{
    const double round_off = 0x1.8p52; /* adding it leaves no place for a fraction */
    const Vector shifted = rounded(x) * 0.6366197723675814 + round_off;
    const Vector n = shifted - round_off;
    quadrant = (Words) shifted;
    /* The first two products are exact, as in lanes.h. */
    const Pair r = tidy((x - Pair(n * 1.5707963267341256)) - Pair(n * 6.077100506303966e-11)
        - Pair(n * 2.0222662487959506e-21));
    const Pair z = r * r;
    const Vector y = z.hi;
    const Vector odd = y * (-1.0 / 5040 + y * (1.0 / 362880 + y * (-1.0 / 39916800 + y * (1.0 / 6227020800
        + y * (-1.0 / 1307674368000 + y * (1.0 / 355687428096000 - y * (1.0 / 121645100408832000)))))));
    const Vector even = y * (-1.0 / 720 + y * (1.0 / 40320 + y * (-1.0 / 3628800 + y * (1.0 / 479001600
        + y * (-1.0 / 87178291200 + y * (1.0 / 20922789888000 - y * (1.0 / 6402373705728000)))))));
    const Pair sixth(0.16666666666666666, 9.251858538542972e-18);
    const Pair odds = (Pair(0.008333333333333333, 1.1564823173178713e-19) + Pair(odd)) * z - sixth;
    const Pair evens = (Pair(0.041666666666666664, 2.312964634635743e-18) + Pair(even)) * z - Pair(0.5);
    sine = r + r * (odds * z);
    cosine = Pair(1.0) + evens * z;
}

/* The sine `quarters` quarter turns further on. */
static inline Pair turned(const Pair& x, int quarters)
{
    Pair sine, cosine;
    Words quadrant;
    sine_and_cosine(x, sine, cosine, quadrant);
    const Words n = quadrant + quarters;
    const Words odd = -(n & 1), sign = (n & 2) << 62;
    const Pair value = chosen(odd, cosine, sine);
    const Vector size = rounded(x);
    const Words far = ~((size <= FARTHEST) & (size >= -FARTHEST)); /* and NaN */
    return Pair((Vector) (((Words) value.hi ^ sign) | far), (Vector) ((Words) value.lo ^ sign));
}

static inline Pair sin(const Pair& x) { return turned(x, 0); }
static inline Pair cos(const Pair& x) { return turned(x, 1); }
static inline Pair tan(const Pair& x) { return sin(x) / cos(x); }

/* ---- exponential and hyperbolic functions ----
 *
 * exp x - 1 for a sixteenth of what is left of x without a multiple of log 2 by its series; then it is squared
 * four times. */

static inline Pair exp(const Pair& x)
{
    const double round_off = 0x1.8p52;
    const Pair argument = tidy(x);
    const Vector n = (argument.hi * 1.4426950408889634 + round_off) - round_off;
    /* The product with the first part of log 2, of 33 bits, is exact. */
    const Pair r = tidy((argument - Pair(n * 0.6931471803691238)) - exact_product(n, Vector{} + 1.9082149292705877e-10));
    const Pair t = times_power(r, 0.0625), z = t * t;
    const Vector y = t.hi;
    const Vector rest = y * y * y * y * (1.0 / 24 + y * (1.0 / 120 + y * (1.0 / 720 + y * (1.0 / 5040 + y * (1.0 / 40320
        + y * (1.0 / 362880))))));
    Pair above = t + times_power(z, 0.5) + t * z * Pair(0.16666666666666666, 9.251858538542972e-18) + Pair(rest);
    for (int i = 0; i < 4; i++) above = times_power(above, 2.0) + above * above;
    Pair value = Pair(1.0) + above;
    for (int i = 0; i < LANES; i++) {
        /* 2^n overflows before its product does: in two halves. */
        const int whole = argument.hi[i] > 800.0 ? 1200 : argument.hi[i] > -800.0 ? (int) n[i] : -1200, half = whole / 2;
        value.hi[i] = ldexp(ldexp(value.hi[i], half), whole - half);
        value.lo[i] = ldexp(ldexp(value.lo[i], half), whole - half);
    }
    return value;
}
static inline Pair log(const Pair& x)
{
    const Pair guess(log(Lanes(rounded(x))));
    return guess + (x * exp(-guess) - Pair(1.0));
}
static inline Pair sinh(const Pair& x)
{
    const Pair e = exp(x);
    return times_power(e - Pair(1.0) / e, 0.5);
}
static inline Pair cosh(const Pair& x)
{
    const Pair e = exp(x);
    return times_power(e + Pair(1.0) / e, 0.5);
}
static inline Pair tanh(const Pair& x)
{
    const Pair e = exp(times_power(fabs(x), -2.0)), size = (Pair(1.0) - e) / (Pair(1.0) + e);
    return chosen(rounded(x) < 0.0, -size, size);
}

/* ---- inverse functions: that of doubles, corrected once ---- */

static inline Pair asin(const Pair& x)
{
    const Pair guess(asin(Lanes(rounded(x))));
    return guess + (x - sin(guess)) / cos(guess);
}
static inline Pair acos(const Pair& x)
{
    const Pair guess(acos(Lanes(rounded(x))));
    return guess + (cos(guess) - x) / sin(guess);
}
static inline Pair atan(const Pair& x)
{
    const Pair guess(atan(Lanes(rounded(x)))), s = sin(guess), c = cos(guess);
    return guess + (x * c - s) / (c + x * s);
}

#endif
