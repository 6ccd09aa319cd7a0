"""What the step function in C is made of, for any walker: what is written @SO@ is filled in by `c_step`.

It decides as `stridemap.solver.walks` does what ends a swing phase. Between two samples of the motion, which
are the ends of Runge-Kutta steps, a zero is located by Newton's method on the length of a step from the first
of them: a shorter step is as good as a long one, so that nothing is interpolated.
"""

SOURCE = r"""
#undef STRIDEMAP_OLD_SIGNATURES /* that is for callers */
#include "@model@_step.h"

#include <float.h>
#include <math.h>

#define REAL(x) ((stridemap_real) (x))
#ifdef STRIDEMAP_FLOAT
#define FABS(x) fabsf(x)
#define SQRT(x) sqrtf(x)
#define FLOOR(x) floorf(x)
#define EPSILON FLT_EPSILON
#define LARGEST FLT_MAX
#define ROUNDING 1e-5f /* of a condition, in terms of its parts */
#define LEVEL 1e-4f    /* difference of heights, in terms of the distance of the feet */
#else
#define FABS(x) fabs(x)
#define SQRT(x) sqrt(x)
#define FLOOR(x) floor(x)
#define EPSILON DBL_EPSILON
#define LARGEST DBL_MAX
#define ROUNDING 1e-12
#define LEVEL 1e-6
#endif

enum {
    N = @n@, /* coordinates */
    STAGES = 6, /* of the Runge-Kutta method */
    TRIES = 60, /* most steps of a search for a zero; half a dozen are usual */
    AUTONOMOUS = @autonomous@, /* whether the motion depends on the state alone, not on a clock */
    GOES_ON = -1
};

/* A time since touchdown with coordinates and rates. */
typedef struct {
    stridemap_real t, q[N], v[N];
} moment;

/* The touchdown condition, its rate, and what is negative where a touchdown counts. */
typedef struct {
    stridemap_real h, dh, side;
} condition;

/* -- motion ------------------------------------------------------------------------------------------- */

/* Dormand and Prince's method of order 5. */
static const stridemap_real NODE[STAGES] = {
    REAL(0.0), REAL(1.0)/5, REAL(3.0)/10, REAL(4.0)/5, REAL(8.0)/9, REAL(1.0)
};
static const stridemap_real PART[STAGES][STAGES - 1] = {
    {REAL(0.0), REAL(0.0), REAL(0.0), REAL(0.0), REAL(0.0)},
    {REAL(1.0)/5, REAL(0.0), REAL(0.0), REAL(0.0), REAL(0.0)},
    {REAL(3.0)/40, REAL(9.0)/40, REAL(0.0), REAL(0.0), REAL(0.0)},
    {REAL(44.0)/45, REAL(-56.0)/15, REAL(32.0)/9, REAL(0.0), REAL(0.0)},
    {REAL(19372.0)/6561, REAL(-25360.0)/2187, REAL(64448.0)/6561, REAL(-212.0)/729, REAL(0.0)},
    {REAL(9017.0)/3168, REAL(-355.0)/33, REAL(46732.0)/5247, REAL(49.0)/176, REAL(-5103.0)/18656}
};
static const stridemap_real WEIGHT[STAGES] = {
    REAL(35.0)/384, REAL(0.0), REAL(500.0)/1113, REAL(125.0)/192, REAL(-2187.0)/6784, REAL(11.0)/84
};

/* The moment that comes `tau` after another one: one Runge-Kutta step. */
static moment after(const moment *begin, stridemap_real tau, const stridemap_real *p)
{
    moment at = *begin;
    stridemap_real dq[STAGES][N], dv[STAGES][N];

    for (int stage = 0; stage <= STAGES; stage++) {
        const stridemap_real *part = stage < STAGES ? PART[stage] : WEIGHT;
        for (int i = 0; i < N; i++) {
            stridemap_real sum_q = REAL(0.0), sum_v = REAL(0.0);
            for (int j = 0; j < stage; j++) {
                sum_q += part[j] * dq[j][i];
                sum_v += part[j] * dv[j][i];
            }
            at.q[i] = begin->q[i] + tau * sum_q;
            at.v[i] = begin->v[i] + tau * sum_v;
        }
        if (stage == STAGES)
            break;
        at.t = begin->t + NODE[stage] * tau;
        @model@_state_derivative(at.t, at.q, at.v, 0, p, dq[stage], dv[stage]);
    }
    at.t = begin->t + tau;
    return at;
}

static int is_finite(const moment *at)
{
    int finite = FABS(at->t) <= LARGEST;

    for (int i = 0; i < N; i++)
        finite = finite && FABS(at->q[i]) <= LARGEST && FABS(at->v[i]) <= LARGEST;
    return finite;
}

/* -- what is where ------------------------------------------------------------------------------------ */

static condition look(const moment *at, const stridemap_real *p)
{
    condition seen;

    @model@_touchdown_condition(at->t, at->q, at->v, 0, p, &seen.h, &seen.dh, &seen.side);
    return seen;
}

/* Whether both feet are on the ground: the touchdown condition is zero, but for rounding. */
static int in_double_support(const moment *at, const stridemap_real *p)
{
    stridemap_real gradient[N], size = REAL(0.0);

    @model@_touchdown_condition_dq(at->t, at->q, at->v, 0, p, gradient);
    for (int i = 0; i < N; i++)
        size += FABS(gradient[i] * at->q[i]);
    return FABS(look(at, p).h) <= ROUNDING * size;
}

/* Velocity of the centre of mass along the ground. */
static stridemap_real speed(const moment *at, const stridemap_real *p)
{
    stridemap_real com[2], dcom[2];

    @model@_centre_of_mass(at->t, at->q, at->v, 0, p, com, dcom);
    return dcom[0];
}

/* The swing foot from the stance foot. */
static void legs(const moment *at, const stridemap_real *p, stridemap_real apart[2])
{
    stridemap_real foot[2], dfoot[2], stance[2];

    @model@_swing_foot(at->t, at->q, at->v, 0, p, foot, dfoot);
    @model@_stance_foot(at->t, at->q, at->v, 0, p, stance);
    apart[0] = foot[0] - stance[0];
    apart[1] = foot[1] - stance[1];
}

/* Just after touchdown: whether the stance foot has become the swing foot, as on two legs, not on a wheel. */
static int alternates(const moment *at, const stridemap_real *p)
{
    moment old = *at;
    stridemap_real ahead[2], behind[2], most, size;

    @model@_before_touchdown(at->t, at->q, at->v, 0, p, old.q);
    legs(&old, p, ahead);
    legs(at, p, behind);
    most = FABS(ahead[0] + behind[0]);
    if (FABS(ahead[1] + behind[1]) > most)
        most = FABS(ahead[1] + behind[1]);
    size = FABS(ahead[0]) > FABS(ahead[1]) ? FABS(ahead[0]) : FABS(ahead[1]);
    return most <= LEVEL * size;
}

/* Lowest height of a swing foot on the ground: that ahead, or, on stairs, that behind. It is found at a
 * touchdown, which Newton's method leads to from the middle of the search box. */
static stridemap_real ground(const stridemap_real *p)
{
    const stridemap_real z[@nz@] = {@middle@};
    moment at, old;
    stridemap_real gradient[N], size, h, foot[2], behind[2], dfoot[2];

    at.t = REAL(0.0);
    @model@_section_state(z, p, at.q, at.v);
    for (int tries = 0; tries < TRIES && !in_double_support(&at, p); tries++) {
        @model@_touchdown_condition_dq(at.t, at.q, at.v, 0, p, gradient);
        size = REAL(0.0);
        for (int i = 0; i < N; i++)
            size += gradient[i] * gradient[i];
        if (!(size > REAL(0.0)))
            break;
        h = look(&at, p).h;
        for (int i = 0; i < N; i++)
            at.q[i] -= h * gradient[i] / size;
    }
    old = at;
    @model@_before_touchdown(at.t, at.q, at.v, 0, p, old.q);
    @model@_swing_foot(old.t, old.q, old.v, 0, p, foot, dfoot);
    @model@_swing_foot(at.t, at.q, at.v, 0, p, behind, dfoot);
    return alternates(&at, p) && behind[1] < foot[1] ? behind[1] : foot[1];
}

/* -- what ends a swing phase -------------------------------------------------------------------------- */

/* Whether a walker with both feet on the ground has come back onto the foot behind. */
static int on_the_foot_behind(const moment *at, const stridemap_real *p)
{
    stridemap_real foot[2], dfoot[2], apart[2], reach;

    if (!(speed(at, p) < REAL(0.0)))
        return 0;
    @model@_swing_foot(at->t, at->q, at->v, 0, p, foot, dfoot);
    legs(at, p, apart);
    reach = LEVEL * SQRT(apart[0] * apart[0] + apart[1] * apart[1]);
    if (FABS(apart[1]) > reach && FABS(foot[1] - ground(p)) > reach)
        return 1; /* the foot that touches is another one: the spoke behind */
    return apart[0] < REAL(0.0) && dfoot[1] < REAL(0.0);
}

/* What ends a swing phase before it has begun: a walker that cannot leave the foot behind. */
static int at_start(const moment *at, const stridemap_real *p)
{
    moment next = *at;
    stridemap_real dq[N], foot[2], dfoot[2];
    int resting = 1, stays = 1, pressed;

    if (look(at, p).side < REAL(0.0) || !in_double_support(at, p))
        return GOES_ON;
    for (int i = 0; i < N; i++)
        resting = resting && !(FABS(at->v[i]) > REAL(0.0));
    if (resting) /* what the accelerations lead to */
        @model@_state_derivative(at->t, at->q, at->v, 0, p, dq, next.v);
    if (alternates(at, p)) {
        @model@_swing_foot(next.t, next.q, next.v, 0, p, foot, dfoot);
        pressed = dfoot[1] < REAL(0.0);
    } else {
        pressed = speed(&next, p) < REAL(0.0);
    }
    for (int i = 0; i < N; i++)
        stays = stays && !(FABS(next.v[i]) > REAL(0.0));
    if (!resting && pressed && speed(at, p) < REAL(0.0))
        return @MODEL@_ROCKS_BACK;
    if (AUTONOMOUS && resting && (pressed || stays))
        return @MODEL@_STOPS;
    return GOES_ON;
}

/* A fall: @fall@. */
static int fallen(const moment *at, const stridemap_real *p)
{
    stridemap_real com[2], dcom[2], stance[2];

    @model@_centre_of_mass(at->t, at->q, at->v, 0, p, com, dcom);
    if (!(@down@))
        return GOES_ON;
    @model@_stance_foot(at->t, at->q, at->v, 0, p, stance);
    if (com[0] < stance[0])
        return @MODEL@_FALLS_BACKWARD;
    return @MODEL@_FALLS_FORWARD;
}

/* Where the condition, which is below zero or not at both ends of a step, turns and has changed its sign in
 * between; 0 where it has not. */
static stridemap_real beyond(const moment *begin, stridemap_real tau, int below, const stridemap_real *p)
{
    stridemap_real low = REAL(0.0), high = tau;

    for (int tries = 0; tries < TRIES; tries++) {
        const stridemap_real middle = (low + high) / 2;
        const moment at = after(begin, middle, p);
        const condition seen = look(&at, p);
        if ((seen.h < REAL(0.0)) != below)
            return middle;
        if (FABS(seen.dh) * (high - low) < FABS(seen.h))
            break; /* it cannot come that far */
        if ((seen.dh > REAL(0.0)) == below)
            low = middle;
        else
            high = middle;
    }
    return REAL(0.0);
}

/* Where the condition changes its sign between two times of a step: Newton's method, kept between them. */
static stridemap_real crossing(const moment *begin, stridemap_real low, stridemap_real high, int rising,
        const stridemap_real *p)
{
    const stridemap_real sign = rising ? REAL(1.0) : REAL(-1.0);
    const stridemap_real close = 2 * EPSILON * (begin->t + high);
    const moment first = after(begin, low, p), last = after(begin, high, p);
    const condition left = look(&first, p);
    stridemap_real tau = (low + high) / 2;

    /* Just after touchdown the condition is zero, and its rate says on which side it goes on. */
    if (!(sign * left.h < REAL(0.0) || sign * left.dh < REAL(0.0)) || sign * look(&last, p).h < REAL(0.0))
        return low;
    for (int tries = 0; tries < TRIES && high - low > close; tries++) {
        const moment at = after(begin, tau, p);
        const condition seen = look(&at, p);
        const stridemap_real move = seen.h / seen.dh;
        if (sign * seen.h < REAL(0.0))
            low = tau;
        else
            high = tau;
        if (FABS(move) <= close)
            return tau - move;
        tau -= move;
        if (!(tau > low && tau < high))
            tau = (low + high) / 2;
    }
    return tau;
}

/* The first event within a step of the integrator, and the moment of it. */
static int event(const moment *begin, stridemap_real tau, condition left, condition right, int *below,
        const stridemap_real *p, moment *found)
{
    stridemap_real ends[3];
    int changes = 0;

    ends[0] = REAL(0.0);
    ends[1] = ends[2] = tau;
    if (*below != (right.h < REAL(0.0))) {
        changes = 1;
    } else if (*below ? left.dh > REAL(0.0) && right.dh < REAL(0.0)
                      : left.dh < REAL(0.0) && right.dh > REAL(0.0)) {
        ends[1] = beyond(begin, tau, *below, p);
        changes = ends[1] > REAL(0.0) ? 2 : 0;
    }
    for (int i = 0; i < changes; i++) {
        const int rising = *below;
        stridemap_real side;
        moment later;
        *found = after(begin, crossing(begin, ends[i], ends[i + 1], rising, p), p);
        side = look(found, p).side;
        *below = !*below;
        if (rising && side < REAL(0.0))
            return @MODEL@_TOUCHDOWN;
        if (side < REAL(0.0))
            continue;
        later = after(found, tau / 64, p);
        if (look(&later, p).side > side && on_the_foot_behind(found, p))
            return @MODEL@_ROCKS_BACK;
    }
    return GOES_ON;
}

/* A swing phase, up to the moment that ends it. */
static int swing_phase(moment *at, const stridemap_real *p, stridemap_real dt, int most)
{
    const stridemap_real start = at->t;
    condition left = look(at, p);
    int below, how;

    if (!is_finite(at) || !(FABS(left.h) <= LARGEST))
        return @MODEL@_NOT_FINITE;
    if ((how = at_start(at, p)) != GOES_ON)
        return how;
    below = left.h < REAL(0.0) && !in_double_support(at, p);
    for (int i = 1; i <= most; i++) {
        moment found, next = after(at, dt, p);
        const condition right = look(&next, p);
        next.t = start + REAL(i) * dt;
        if (!is_finite(&next) || !(FABS(right.h) <= LARGEST))
            return @MODEL@_NOT_FINITE;
        how = event(at, dt, left, right, &below, p, &found);
        *at = how == GOES_ON ? next : found;
        if (how == GOES_ON)
            how = fallen(at, p);
        if (how != GOES_ON)
            return how;
        left = right;
    }
    return @MODEL@_NO_TOUCHDOWN;
}
"""
