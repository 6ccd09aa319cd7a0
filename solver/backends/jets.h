/* Numbers that carry derivatives: a value, its derivatives in two directions a and b, and the second derivative
 * in both (hyper-dual numbers: J. Fike and J. Alonso 2011, doi:10.2514/6.2011-886). The kernels' C, compiled as
 * C++ with `Jet` for its numbers, is differentiated exactly, to rounding. The values have the bits of `Lanes`.
 *
 * Compiled after lanes.h.
 */
#ifndef STRIDEMAP_JETS_H
#define STRIDEMAP_JETS_H

struct Jet {
    Lanes x, a, b, ab;

    Jet() = default;
    Jet(double value) : x(value), a(0.0), b(0.0), ab(0.0) {}
    Jet(Lanes x, Lanes a, Lanes b, Lanes ab) : x(x), a(a), b(b), ab(ab) {}

    Jet& operator+=(const Jet& y);
    Jet& operator-=(const Jet& y);
    Jet& operator*=(const Jet& y);
    Jet& operator/=(const Jet& y);

    explicit operator bool() const __attribute__((error("a branch on lanes")));
};

static inline Jet operator-(const Jet& u) { return Jet(-u.x, -u.a, -u.b, -u.ab); }
static inline Jet operator+(const Jet& u, const Jet& v) { return Jet(u.x + v.x, u.a + v.a, u.b + v.b, u.ab + v.ab); }
static inline Jet operator-(const Jet& u, const Jet& v) { return Jet(u.x - v.x, u.a - v.a, u.b - v.b, u.ab - v.ab); }
static inline Jet operator*(const Jet& u, const Jet& v)
{
    return Jet(u.x * v.x, u.a * v.x + u.x * v.a, u.b * v.x + u.x * v.b,
        (u.ab * v.x + u.x * v.ab) + (u.a * v.b + u.b * v.a));
}
static inline Jet operator/(const Jet& u, const Jet& v)
{
    const Lanes x = u.x / v.x, a = (u.a - x * v.a) / v.x, b = (u.b - x * v.b) / v.x;
    return Jet(x, a, b, (u.ab - x * v.ab - (a * v.b + b * v.a)) / v.x);
}

inline Jet& Jet::operator+=(const Jet& y) { return *this = *this + y; }
inline Jet& Jet::operator-=(const Jet& y) { return *this = *this - y; }
inline Jet& Jet::operator*=(const Jet& y) { return *this = *this * y; }
inline Jet& Jet::operator/=(const Jet& y) { return *this = *this / y; }

/* Comparisons are of values, and have no derivatives. */
static inline Jet operator<(const Jet& u, const Jet& v) { return Jet(u.x < v.x, 0.0, 0.0, 0.0); }
static inline Jet operator<=(const Jet& u, const Jet& v) { return Jet(u.x <= v.x, 0.0, 0.0, 0.0); }
static inline Jet operator>(const Jet& u, const Jet& v) { return Jet(u.x > v.x, 0.0, 0.0, 0.0); }
static inline Jet operator>=(const Jet& u, const Jet& v) { return Jet(u.x >= v.x, 0.0, 0.0, 0.0); }
static inline Jet operator==(const Jet& u, const Jet& v) { return Jet(u.x == v.x, 0.0, 0.0, 0.0); }
static inline Jet operator!=(const Jet& u, const Jet& v) { return Jet(u.x != v.x, 0.0, 0.0, 0.0); }

/* A function of u from its value, its first and its second derivative there. */
static inline Jet composed(const Jet& u, Lanes value, Lanes first, Lanes second)
{
    return Jet(value, first * u.a, first * u.b, first * u.ab + second * (u.a * u.b));
}

static inline Jet sin(const Jet& u)
{
    const Lanes s = sin(u.x);
    return composed(u, s, cos(u.x), -s);
}
static inline Jet cos(const Jet& u)
{
    const Lanes c = cos(u.x);
    return composed(u, c, -sin(u.x), -c);
}
static inline Jet tan(const Jet& u)
{
    const Lanes t = tan(u.x), first = 1.0 + t * t;
    return composed(u, t, first, 2.0 * t * first);
}
static inline Jet sqrt(const Jet& u)
{
    const Lanes root = sqrt(u.x), first = 0.5 / root;
    return composed(u, root, first, -0.5 * first / u.x);
}
static inline Jet exp(const Jet& u)
{
    const Lanes e = exp(u.x);
    return composed(u, e, e, e);
}
static inline Jet log(const Jet& u)
{
    const Lanes first = 1.0 / u.x;
    return composed(u, log(u.x), first, -first * first);
}
static inline Jet asin(const Jet& u)
{
    const Lanes first = 1.0 / sqrt(1.0 - u.x * u.x);
    return composed(u, asin(u.x), first, u.x * first * first * first);
}
static inline Jet acos(const Jet& u)
{
    const Lanes first = 1.0 / sqrt(1.0 - u.x * u.x);
    return composed(u, acos(u.x), -first, -u.x * first * first * first);
}
static inline Jet atan(const Jet& u)
{
    const Lanes first = 1.0 / (1.0 + u.x * u.x);
    return composed(u, atan(u.x), first, -2.0 * u.x * first * first);
}
static inline Jet sinh(const Jet& u)
{
    const Lanes s = sinh(u.x);
    return composed(u, s, cosh(u.x), s);
}
static inline Jet cosh(const Jet& u)
{
    const Lanes c = cosh(u.x);
    return composed(u, c, sinh(u.x), c);
}
static inline Jet tanh(const Jet& u)
{
    const Lanes t = tanh(u.x), first = 1.0 - t * t;
    return composed(u, t, first, -2.0 * t * first);
}
static inline Jet fabs(const Jet& u)
{
    const Lanes sign = (u.x > 0.0) - (u.x < 0.0);
    return composed(u, fabs(u.x), sign, 0.0);
}
static inline Jet fmax(const Jet& u, const Jet& v)
{
    const Lanes first = u.x >= v.x, second = 1.0 - first;
    return Jet(fmax(u.x, v.x), first * u.a + second * v.a, first * u.b + second * v.b, first * u.ab + second * v.ab);
}

#endif
