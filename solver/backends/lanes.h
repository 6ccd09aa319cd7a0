/* Several numbers in one: the kernels' C, compiled as C++ with `Lanes` for its numbers, works on that many
 * points at a time. gcc's and clang's vector extension makes it whatever instructions the processor has.
 *
 * No lane ever looks at another, and every operation is rounded as IEEE 754 says (nothing is contracted), so
 * that a lane's result depends neither on its neighbours nor on how many lanes there are.
 *
 * With SINGLE_PRECISION there are twice as many numbers of half the size.
 */
#ifndef STRIDEMAP_LANES_H
#define STRIDEMAP_LANES_H

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#if defined(__AVX512F__)
#define VECTOR_BYTES 64
#elif defined(__AVX2__)
#define VECTOR_BYTES 32
#else
#define VECTOR_BYTES 16
#endif

#ifdef SINGLE_PRECISION
typedef float Real;
typedef int32_t Whole;
#else
typedef double Real;
typedef int64_t Whole;
#endif

#define LANES ((int) (VECTOR_BYTES / sizeof(Real)))

typedef Real Vector __attribute__((vector_size(VECTOR_BYTES)));
typedef Whole Words __attribute__((vector_size(VECTOR_BYTES)));

struct Lanes {
    Vector v;

    Lanes() = default;
    Lanes(double x) : v(Vector{} + (Real) x) {}
    Lanes(Vector x) : v(x) {}

    Lanes& operator+=(Lanes x) { v += x.v; return *this; }
    Lanes& operator-=(Lanes x) { v -= x.v; return *this; }
    Lanes& operator*=(Lanes x) { v *= x.v; return *this; }
    Lanes& operator/=(Lanes x) { v /= x.v; return *this; }

    /* Lanes do not part ways: a kernel that branches on a number is not compiled. */
    explicit operator bool() const __attribute__((error("a branch on lanes")));
};

static inline Lanes operator-(Lanes a) { return -a.v; }
static inline Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
static inline Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
static inline Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
static inline Lanes operator/(Lanes a, Lanes b) { return a.v / b.v; }

/* Comparisons are 1 or 0, as in C. */
static inline Lanes truth(Words w) { return __builtin_convertvector(-w, Vector); }
static inline Lanes operator<(Lanes a, Lanes b) { return truth(a.v < b.v); }
static inline Lanes operator<=(Lanes a, Lanes b) { return truth(a.v <= b.v); }
static inline Lanes operator>(Lanes a, Lanes b) { return truth(a.v > b.v); }
static inline Lanes operator>=(Lanes a, Lanes b) { return truth(a.v >= b.v); }
static inline Lanes operator==(Lanes a, Lanes b) { return truth(a.v == b.v); }
static inline Lanes operator!=(Lanes a, Lanes b) { return truth(a.v != b.v); }

/* ---- sine and cosine ----
 *
 * x = n pi/2 + r with |r| <= pi/4. pi/2 is cut into three parts (Cody and Waite): up to `FARTHEST` the products
 * of n with the first two are exact. Beyond it the result is NaN: such an angle is no walker's. The polynomials
 * interpolate (sin r / r - 1) / r^2 and (cos r - 1 + r^2/2) / r^4, in z = r^2, at the Chebyshev points of the
 * interval. The rounding error of r is not carried along: it changes a sine by no more than that of x does. */

#ifdef SINGLE_PRECISION

static const Real FARTHEST = 1e4f, TWO_OVER_PI = 0.63661975f, HALF_PI[] = {1.5703125f, 0x1.fb4p-12f, 7.54979e-08f},
                  ROUND_OFF = 0x1.8p23f; /* adding it leaves no place for a fraction */

static inline Vector sine_rest(Vector z) { return -0.16666664f + z * (0.008332748f + z * -0.0001958789f); }
static inline Vector cosine_rest(Vector z) { return 0.041666664f + z * (-0.0013888302f + z * 2.4547942e-05f); }

#else

static const Real FARTHEST = 1e6, TWO_OVER_PI = 0.6366197723675814,
                  HALF_PI[] = {1.5707963267341256, 6.077100506303966e-11, 2.0222662487959506e-21},
                  ROUND_OFF = 0x1.8p52; /* adding it leaves no place for a fraction */

static inline Vector sine_rest(Vector z)
{
    return -0.16666666666666666 + z * (0.008333333333330946 + z * (-0.0001984126983675497
        + z * (2.755731610068303e-06 + z * (-2.5051131455427946e-08 + z * 1.591810123027412e-10))));
}

static inline Vector cosine_rest(Vector z)
{
    return 0.041666666666666664 + z * (-0.0013888888888887395 + z * (2.4801587298763433e-05
        + z * (-2.7557317270560326e-07 + z * (2.0876146024689747e-09 + z * -1.1382614868556325e-11))));
}

#endif

struct Reduced {
    Vector r;
    Words quadrant;
};

static inline Reduced reduced(Vector x)
{
    const Vector shifted = x * TWO_OVER_PI + ROUND_OFF, n = shifted - ROUND_OFF;
    return {((x - n * HALF_PI[0]) - n * HALF_PI[1]) - n * HALF_PI[2], (Words) shifted};
}

static inline Vector sine(Vector r)
{
    const Vector z = r * r;
    return r + z * r * sine_rest(z);
}

static inline Vector cosine(Vector r)
{
    const Vector z = r * r;
    return (1 - z * (Real) 0.5) + z * z * cosine_rest(z);
}

static inline Words where_else(Words mask, Words yes, Words no) { return (mask & yes) | (~mask & no); }

/* The sine `quarters` quarter turns further on. */
static inline Lanes turned(Vector x, const Reduced& at, int quarters)
{
    const Words n = at.quadrant + quarters;
    const Words odd = -(n & 1), sign = (n & 2) << (8 * sizeof(Real) - 2);
    const Words value = where_else(odd, (Words) cosine(at.r), (Words) sine(at.r)) ^ sign;
    const Words far = ~((x <= FARTHEST) & (x >= -FARTHEST)); /* and NaN */
    return (Vector) (value | far); /* all bits set: NaN */
}

static inline Lanes sin(Lanes x) { return turned(x.v, reduced(x.v), 0); }
static inline Lanes cos(Lanes x) { return turned(x.v, reduced(x.v), 1); }

/* ---- other functions, lane by lane ---- */

#define LANE_BY_LANE(name)                                        \
    static inline Lanes name(Lanes x)                             \
    {                                                             \
        for (int i = 0; i < LANES; i++) x.v[i] = name(x.v[i]);    \
        return x;                                                 \
    }
LANE_BY_LANE(sqrt)
LANE_BY_LANE(fabs)
LANE_BY_LANE(tan)
LANE_BY_LANE(exp)
LANE_BY_LANE(log)
LANE_BY_LANE(asin)
LANE_BY_LANE(acos)
LANE_BY_LANE(atan)
LANE_BY_LANE(sinh)
LANE_BY_LANE(cosh)
LANE_BY_LANE(tanh)

static inline Lanes fmax(Lanes x, Lanes y)
{
    for (int i = 0; i < LANES; i++) x.v[i] = fmax(x.v[i], y.v[i]);
    return x;
}

#endif
