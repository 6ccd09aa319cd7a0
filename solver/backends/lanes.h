/* Several numbers in one: the kernels' C, compiled as C++ with `Lanes` for its numbers, works on that many
 * points at a time. gcc's and clang's vector extension makes it whatever instructions the processor has.
 *
 * No lane ever looks at another, and every operation is rounded as IEEE 754 says (nothing is contracted), so
 * that a lane's result depends neither on its neighbours nor on how many lanes there are.
 */
#ifndef STRIDEMAP_LANES_H
#define STRIDEMAP_LANES_H

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#if defined(__AVX512F__)
#define LANES 8
#elif defined(__AVX2__)
#define LANES 4
#else
#define LANES 2
#endif

typedef double Doubles __attribute__((vector_size(8 * LANES)));
typedef int64_t Words __attribute__((vector_size(8 * LANES)));

struct Lanes {
    Doubles v;

    Lanes() = default;
    Lanes(double x) : v(Doubles{} + x) {}
    Lanes(Doubles x) : v(x) {}

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
static inline Lanes truth(Words w) { return __builtin_convertvector(-w, Doubles); }
static inline Lanes operator<(Lanes a, Lanes b) { return truth(a.v < b.v); }
static inline Lanes operator<=(Lanes a, Lanes b) { return truth(a.v <= b.v); }
static inline Lanes operator>(Lanes a, Lanes b) { return truth(a.v > b.v); }
static inline Lanes operator>=(Lanes a, Lanes b) { return truth(a.v >= b.v); }
static inline Lanes operator==(Lanes a, Lanes b) { return truth(a.v == b.v); }
static inline Lanes operator!=(Lanes a, Lanes b) { return truth(a.v != b.v); }

/* ---- sine and cosine ----
 *
 * x = n pi/2 + (r + e) with |r| <= pi/4. pi/2 is cut into three parts (Cody and Waite): the products of n
 * with the first two, of 33 bits each, are exact for |n| < 2^20, and e is what r has lost. The polynomials
 * interpolate (sin r / r - 1) / r^2 and (cos r - 1 + r^2/2) / r^4 at the Chebyshev points of the interval.
 * Beyond `FARTHEST` the result is NaN: such an angle is no walker's. */

#define FARTHEST 1.0e6

struct Reduced {
    Doubles r, e;
    Words quadrant;
};

static inline Reduced reduced(Doubles x)
{
    const double round_off = 0x1.8p52; /* adding it leaves no place for a fraction */
    const Doubles shifted = x * 0.6366197723675814 + round_off;
    const Doubles n = shifted - round_off;
    const Doubles t = x - n * 1.5707963267341256;
    const Doubles a = n * 6.077100506303966e-11;
    const Doubles s = t - a;
    const Doubles b = n * 2.0222662487959506e-21 - ((t - s) - a);
    const Doubles r = s - b;
    Reduced out = {r, (s - r) - b, (Words) shifted};
    return out;
}

static inline Doubles sine(Doubles r, Doubles e)
{
    const Doubles z = r * r;
    const Doubles p = 0.008333333333330946 + z * (-0.0001984126983675497 + z * (2.755731610068303e-06
        + z * (-2.5051131455427946e-08 + z * 1.591810123027412e-10)));
    return r + (z * (r * (-0.16666666666666666 + z * p)) + e * (1.0 - 0.5 * z));
}

static inline Doubles cosine(Doubles r, Doubles e)
{
    const Doubles z = r * r, half = 0.5 * z;
    const Doubles p = 0.041666666666666664 + z * (-0.0013888888888887395 + z * (2.4801587298763433e-05
        + z * (-2.7557317270560326e-07 + z * (2.0876146024689747e-09 + z * -1.1382614868556325e-11))));
    const Doubles w = 1.0 - half;
    return w + (((1.0 - w) - half) + (z * z * p - r * e));
}

static inline Words where_else(Words mask, Words yes, Words no) { return (mask & yes) | (~mask & no); }

/* The sine `quarters` quarter turns further on. */
static inline Lanes turned(Doubles x, const Reduced& at, int quarters)
{
    const Words n = at.quadrant + quarters;
    const Words odd = -(n & 1), sign = (n & 2) << 62;
    const Words value = where_else(odd, (Words) cosine(at.r, at.e), (Words) sine(at.r, at.e)) ^ sign;
    const Words far = ~((x <= FARTHEST) & (x >= -FARTHEST)); /* and NaN */
    return (Doubles) (value | far); /* all bits set: NaN */
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
