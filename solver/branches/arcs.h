/* Arclength steps of many branches, as arcs.py takes them, in C++: compiled after lanes.h and lockstep.h.
 *
 * A branch waits for the derivative at its predicted point, then, unless that will do, for residuals at corrected
 * ones, and where its tangent turns sharply for the derivative at the last of these. Those that wait for the same
 * kernel are served `LANES` at a time. What comes out for a branch depends neither on the others nor on the number
 * of lanes, nor on the processor: no function of the C library is called that is not exactly rounded. */

/* What stays the same: see the structure of the same name in arcs_in_lanes.py. Matrices are stored by rows. */
struct Course {
    casadi_int n_unknowns, n_params, n_levels, n_modes, n_stops, n_beginnings, max_steps, max_corrections;
    double shortest, longest, ds_min, ds_max, step_growth, step_shrink, min_tangent_cosine, easy_tangent_cosine;
    double tolerance, short_correction, correction_ratio, contraction, sharp, sideways, telling;
    double on_curve, bulge;
    const Kernel *const *jacobian_along, *const *residual;
    const double *largest_phase, *scale, *params, *direction, *modes, *stop_key, *stop, *beginning;
    const casadi_int *line, *stop_number;
};

/* Foremost points of branches, and what comes of them: see `Heads`. */
struct Fronts {
    const casadi_int* branch;
    double *x, *tangent, *bend, *ds, *idle;
    casadi_int *steps, *passed;
    double *points, *tangents;
    unsigned char* met_from_behind;
};

namespace {

/* ---- vectors and matrices of n entries a row ---- */

double dot(const double* a, const double* b, casadi_int n)
{
    double sum = 0;
    for (casadi_int k = 0; k < n; k++) sum += a[k] * b[k];
    return sum;
}

/* Product of two vectors in terms of a scale. */
double product(const double* a, const double* b, const double* scale, casadi_int n)
{
    double sum = 0;
    for (casadi_int k = 0; k < n; k++) sum += (a[k] / scale[k]) * (b[k] / scale[k]);
    return sum;
}

double size_of(const double* a, const double* scale, casadi_int n) { return sqrt(product(a, a, scale, n)); }

/* Triangular factors of a matrix in its place, with row interchanges. */
void factorise(double* a, casadi_int* pivot, casadi_int n)
{
    for (casadi_int c = 0; c < n; c++) {
        casadi_int largest = c;
        for (casadi_int r = c + 1; r < n; r++)
            if (fabs(a[r * n + c]) > fabs(a[largest * n + c])) largest = r;
        pivot[c] = largest;
        for (casadi_int k = 0; k < n; k++) {
            const double t = a[c * n + k];
            a[c * n + k] = a[largest * n + k];
            a[largest * n + k] = t;
        }
        for (casadi_int r = c + 1; r < n; r++) {
            const double factor = a[r * n + c] /= a[c * n + c];
            for (casadi_int k = c + 1; k < n; k++) a[r * n + k] -= factor * a[c * n + k];
        }
    }
}

/* The solution for a right-hand side, in its place. */
void solve_factorised(const double* a, const casadi_int* pivot, double* b, casadi_int n)
{
    for (casadi_int c = 0; c < n; c++) {
        const double t = b[c];
        b[c] = b[pivot[c]];
        b[pivot[c]] = t;
    }
    for (casadi_int r = 1; r < n; r++) b[r] -= dot(a + r * n, b, r);
    for (casadi_int r = n - 1; r >= 0; r--)
        b[r] = (b[r] - dot(a + r * n + r + 1, b + r + 1, n - r - 1)) / a[r * n + r];
}

/* ---- branches ---- */

struct Head {
    casadi_int next; /* that waits for the same kernel */
    casadi_int level, corrections, tries;
    bool easy, held; /* the latter: the point is on the branch, and its tangent is waited for */
    double length, size, cosine;
    double *y, *across, *turned, *matrix;
    casadi_int* pivot;
};

class Arcs {
public:
    Arcs(const Course& course, const Fronts& fronts, casadi_int n, casadi_int tries)
        : c(course), f(fronts), n(n), m(course.n_unknowns + 1), tries(tries), queues(2 * course.n_levels)
    {
        const casadi_int own = m * (m + 3);
        heads = (Head*) malloc((size_t) (n + 1) * sizeof(Head));
        data = (double*) malloc((size_t) ((n + 1) * own) * sizeof(double));
        pivots = (casadi_int*) malloc((size_t) ((n + 1) * m) * sizeof(casadi_int));
        first = (casadi_int*) malloc((size_t) queues * sizeof(casadi_int));
        waiting = (casadi_int*) calloc((size_t) queues, sizeof(casadi_int));
        ready = heads && data && pivots && first && waiting;
        for (casadi_int i = 0; ready && i < n; i++) {
            Head& head = heads[i];
            head.tries = 0;
            head.y = data + i * own;
            head.across = head.y + m;
            head.turned = head.across + m;
            head.matrix = head.turned + m;
            head.pivot = pivots + i * m;
        }
        scratch = data + n * own;
    }

    ~Arcs()
    {
        free(heads); free(data); free(pivots); free(first); free(waiting);
    }

    /* Returns as lockstep_map. */
    int run()
    {
        if (!ready) return 1;
        for (casadi_int i = 0; i < n; i++) go_on(i);
        for (;;) {
            casadi_int longest = 0;
            for (casadi_int q = 1; q < queues; q++)
                if (waiting[q] > waiting[longest]) longest = q;
            if (!waiting[longest]) return 0;
            const int status = serve(longest);
            if (status) return status;
        }
    }

private:
    const Course& c;
    const Fronts& f;
    const casadi_int n, m, tries, queues;
    Head* heads;
    double *data, *scratch; /* the latter of size m (m + 3) */
    casadi_int *pivots, *first, *waiting;
    bool ready;

    Arcs(const Arcs&);
    Arcs& operator=(const Arcs&);

    /* Evaluate the kernel of a queue for up to `LANES` that wait in it, and go on with each. */
    int serve(casadi_int q)
    {
        const casadi_int nu = c.n_unknowns, level = q / 2;
        const bool along = q % 2 == 0;
        const casadi_int in_size[] = {nu, c.n_params, c.n_params}, out_size[] = {nu * nu, nu, nu};
        Call call(along ? c.jacobian_along[level] : c.residual[level], along ? 3 : 2, in_size, along ? 3 : 1,
            along ? out_size : out_size + 1);
        if (!call.ready) return 1;
        casadi_int served[LANES];
        int used = 0;
        for (; used < LANES && waiting[q]; used++, waiting[q]--) {
            served[used] = first[q];
            first[q] = heads[first[q]].next;
        }
        for (int lane = 0; lane < LANES; lane++) {
            const casadi_int i = served[lane < used ? lane : used - 1]; /* others repeat the last */
            const double *const y = heads[i].y, *const p = c.params + f.branch[i] * c.n_params,
                         *const d = c.direction + f.branch[i] * c.n_params;
            put(y, nu, call.in[0], lane);
            for (casadi_int k = 0; k < c.n_params; k++) call.in[1][k].v[lane] = (Real) (p[k] + y[nu] * d[k]);
            if (along) put(d, c.n_params, call.in[2], lane);
        }
        if (call()) return 2;
        for (int lane = 0; lane < used; lane++) {
            if (along) linearised(served[lane], call, lane);
            else corrected(served[lane], call.out[0], lane);
        }
        return 0;
    }

    void wait(casadi_int i, bool along)
    {
        const casadi_int q = 2 * heads[i].level + (along ? 0 : 1);
        heads[i].next = first[q];
        first[q] = i;
        waiting[q]++;
    }

    /* Begin the next arclength step, if there is one. */
    void go_on(casadi_int i)
    {
        Head& head = heads[i];
        if (head.tries++ == tries || !(f.ds[i] >= c.ds_min) || f.steps[i] >= c.max_steps) return;
        const double *const x = f.x + i * m, *const tangent = f.tangent + i * m, *const bend = f.bend + i * m;
        const double s = x[m - 1], slope = tangent[m - 1];
        const double left = slope > 0 ? (1 - s) / slope : slope < 0 ? -s / slope : INFINITY;
        bool at_end = f.ds[i] >= left;
        head.length = at_end ? left : f.ds[i];
        for (casadi_int k = 0; k < m; k++) {
            head.y[k] = x[k] + head.length * tangent[k] + 0.5 * head.length * head.length * bend[k];
            head.across[k] = tangent[k] / (c.scale[k] * c.scale[k]);
        }
        double& there = head.y[m - 1];
        const double end = at_end ? slope > 0 : there > 0.5;
        at_end |= there < 0 || there > 1;
        if (at_end) {
            there = end;
            for (casadi_int k = 0; k < m; k++) head.across[k] = k == m - 1;
        }
        const double mode = c.modes[f.branch[i] * c.n_modes
            + (there > 0 ? there < 1 ? (casadi_int) (there * c.n_modes) : c.n_modes - 1 : 0)];
        double phase = mode * fabs(head.y[m - 2]);
        if (!(phase < INFINITY)) phase = 0; /* no resolution helps */
        for (head.level = 0; head.level < c.n_levels - 1 && c.largest_phase[head.level] < phase;) head.level++;
        head.held = false;
        wait(i, true);
    }

    void linearised(casadi_int i, Call& call, int lane)
    {
        Head& head = heads[i];
        const casadi_int nu = m - 1;
        const double* const tangent = f.tangent + i * m;
        double* const matrix = head.matrix;
        for (casadi_int r = 0; r < nu; r++) {
            for (casadi_int k = 0; k < nu; k++) matrix[r * m + k] = call.out[0][r + k * nu].v[lane];
            matrix[r * m + nu] = call.out[1][r].v[lane];
        }
        turn(head, tangent);
        for (casadi_int k = 0; k < m; k++) matrix[nu * m + k] = head.across[k];
        factorise(matrix, head.pivot, m);
        const double size = correct(head, call.out[2], lane);
        if (head.held) {
            finish(i, true);
            return;
        }
        head.size = size;
        head.cosine = product(head.turned, tangent, c.scale, m);
        head.corrections = 0;
        if (!(size < c.correction_ratio * head.length && head.cosine > c.min_tangent_cosine)) finish(i, false);
        else if (size < allowed(head)) {
            head.easy = true;
            hold(i);
        } else if (c.max_corrections > 0) wait(i, false);
        else finish(i, false);
    }

    void corrected(casadi_int i, const Lanes* residual, int lane)
    {
        Head& head = heads[i];
        const double size = correct(head, residual, lane);
        head.corrections++;
        if (size < allowed(head)) {
            head.easy = head.corrections < c.max_corrections;
            hold(i);
        } else if (size < c.contraction * head.size && head.corrections < c.max_corrections) {
            head.size = size;
            wait(i, false);
        } else finish(i, false);
    }

    /* A point on the branch: its tangent must be known, too. */
    void hold(casadi_int i)
    {
        if (heads[i].cosine < c.sharp) {
            heads[i].held = true;
            wait(i, true);
        } else finish(i, true);
    }

    /* Where steps are short, points must be as exact as these are short. */
    double allowed(const Head& head) const { return fmin(c.tolerance, c.short_correction * head.length); }

    /* The unit tangent, on the side of another one. */
    void turn(Head& head, const double* ahead)
    {
        double* const matrix = scratch;
        for (casadi_int k = 0; k < (m - 1) * m; k++) matrix[k] = head.matrix[k];
        for (casadi_int k = 0; k < m; k++) {
            matrix[(m - 1) * m + k] = ahead[k] / (c.scale[k] * c.scale[k]);
            head.turned[k] = k == m - 1;
        }
        factorise(matrix, head.pivot, m);
        solve_factorised(matrix, head.pivot, head.turned, m);
        const double length = size_of(head.turned, c.scale, m);
        for (casadi_int k = 0; k < m; k++) head.turned[k] /= length;
    }

    /* Newton's correction of the point with the factorised derivative; its length. */
    double correct(Head& head, const Lanes* residual, int lane)
    {
        double* const change = scratch;
        for (casadi_int k = 0; k < m - 1; k++) change[k] = -residual[k].v[lane];
        change[m - 1] = 0;
        solve_factorised(head.matrix, head.pivot, change, m);
        for (casadi_int k = 0; k < m; k++) head.y[k] += change[k];
        return size_of(change, c.scale, m);
    }

    /* How far sideways an arclength step leads, in terms of the mean of the tangents at its ends. */
    double led_sideways(const Head& head, const double* x, const double* tangent)
    {
        double *const way = scratch, *const mean = scratch + m;
        for (casadi_int k = 0; k < m; k++) {
            way[k] = head.y[k] - x[k];
            mean[k] = tangent[k] + head.turned[k];
        }
        const double ratio = size_of(way, c.scale, m) / size_of(mean, c.scale, m);
        for (casadi_int k = 0; k < m; k++) way[k] -= ratio * mean[k];
        return size_of(way, c.scale, m);
    }

    /* End an arclength step: get on if its point is good, and choose the next one. */
    void finish(casadi_int i, bool good)
    {
        Head& head = heads[i];
        double *const x = f.x + i * m, *const tangent = f.tangent + i * m, *const bend = f.bend + i * m;
        good = good && (led_sideways(head, x, tangent) < c.sideways || head.length < c.telling);
        f.steps[i]++;
        if (!good) {
            f.ds[i] = fmin(c.step_shrink * f.ds[i], c.ds_max);
            go_on(i);
            return;
        }
        const double period = head.y[m - 2], s = head.y[m - 1];
        const bool ended = !(period > c.shortest && period <= c.longest) || s <= 0 || s >= 1;
        const bool stopped = stops(i);
        const double length = distance(head.y, x);
        for (casadi_int k = 0; k < m; k++) {
            bend[k] = (head.turned[k] - tangent[k]) / length;
            x[k] = head.y[k];
            tangent[k] = head.turned[k];
        }
        double* const to = f.points + (i * tries + f.passed[i]) * m;
        for (casadi_int k = 0; k < m; k++) to[k] = x[k];
        double* const along = f.tangents + (i * tries + f.passed[i]) * m;
        for (casadi_int k = 0; k < m; k++) along[k] = tangent[k];
        f.passed[i]++;
        f.idle[i] += f.ds[i];
        const double wanted = sqrt((1 - c.easy_tangent_cosine) / fmax(1 - head.cosine, 0));
        const double factor = fmin(fmax(wanted, c.step_shrink), head.easy ? c.step_growth : 1);
        f.ds[i] = ended || stopped ? 0 : fmin(factor * f.ds[i], c.ds_max);
        go_on(i);
    }

    double distance(const double* a, const double* b)
    {
        double* const between = scratch;
        for (casadi_int k = 0; k < m; k++) between[k] = a[k] - b[k];
        return size_of(between, c.scale, m);
    }

    /* Whether known points lie on the branch between the ends of the step: see `Stops`. */
    bool stops(casadi_int i)
    {
        const Head& head = heads[i];
        const double *const x = f.x + i * m, *const tangent = f.tangent + i * m;
        const double length = distance(head.y, x), reach = c.bulge * length * c.scale[m - 1];
        const casadi_int line = c.line[f.branch[i]];
        const double low = key(line, fmin(x[m - 1], head.y[m - 1]) - reach),
                     high = key(line, fmax(x[m - 1], head.y[m - 1]) + reach);
        bool met = false;
        for (casadi_int at = first_stop(low); at < c.n_stops && c.stop_key[at] <= high; at++) {
            const double* const stop = c.stop + at * m;
            double part = 0, away = 0;
            for (casadi_int k = 0; k < m; k++) {
                const double off = (stop[k] - x[k]) / c.scale[k];
                part += off * ((head.y[k] - x[k]) / c.scale[k]);
                away += off * off;
            }
            part /= length * length;
            /* The start itself is at part 0, but for rounding. */
            if (!(part > 1e-9 && part <= 1 && away < 2 * length * length)) continue;
            double apart = 0;
            for (casadi_int k = 0; k < m; k++) {
                const double chord = head.y[k] - x[k], m0 = length * tangent[k], m1 = length * head.turned[k];
                const double there = (((m0 + m1 - 2 * chord) * part + 3 * chord - 2 * m0 - m1) * part + m0) * part + x[k];
                apart += (there - stop[k]) / c.scale[k] * ((there - stop[k]) / c.scale[k]);
            }
            if (!(sqrt(apart) < c.on_curve * length)) continue;
            met = true;
            const casadi_int number = c.stop_number[at];
            if (number < c.n_beginnings && product(head.turned, c.beginning + number * m, c.scale, m) > 0)
                f.met_from_behind[number] = 1;
        }
        return met;
    }

    /* Numbers that order points by line, then position. */
    static double key(casadi_int line, double s) { return (double) line + 0.5 * fmin(fmax(s, -0.5), 1.4); }

    casadi_int first_stop(double low) const
    {
        casadi_int begin = 0, end = c.n_stops;
        while (begin < end) {
            const casadi_int middle = (begin + end) / 2;
            if (c.stop_key[middle] < low) begin = middle + 1;
            else end = middle;
        }
        return begin;
    }
};

} /* namespace */

/* The sizes of both structures, for who fills them to compare. */
extern "C" casadi_int lockstep_arcs_size(int fronts) { return fronts ? sizeof(Fronts) : sizeof(Course); }

/* Up to `tries` arclength steps of each of n branches. Returns as lockstep_map. */
extern "C" int lockstep_arcs(const Course* course, const Fronts* fronts, casadi_int n, casadi_int tries)
{
    Arcs arcs(*course, *fronts, n, tries);
    return arcs.run();
}
