/* Arclength steps of many branches, as arcs.py takes them, in C++: compiled after lanes.h and lockstep.h.
 *
 * A branch waits for the derivative at its predicted point, then, unless that will do, for residuals at corrected
 * ones, and where its tangent turns sharply for the derivative at the last of these. Those that wait for the same
 * kernel are served `LANES` at a time. What comes out for a branch depends neither on the others nor on the number
 * of lanes, nor on the processor: no function of the C library is called that is not exactly rounded. */

/* What stays the same: see the structure of the same name in arcs_in_lanes.py. Points and the like are rows. */
struct Course {
    casadi_int n_unknowns, n_params, n_levels, n_modes, n_stops, n_beginnings, max_steps, max_corrections;
    double shortest, longest, ds_min, ds_max, step_growth, step_shrink, min_tangent_cosine, easy_tangent_cosine;
    double tolerance, short_correction, correction_ratio, contraction, sharp, sideways, telling;
    double on_curve, bulge;
    const Kernel *const *jacobian_along, *const *residual;
    const double *largest_phase, *scale, *params, *direction, *modes, *stop_key, *stop, *beginning;
    const casadi_int *line, *stop_number;
};

/* Foremost points of branches, as in heads.py, and what comes of them. */
struct Heads {
    const casadi_int* branch;
    double *x, *tangent, *bend, *ds, *idle;
    casadi_int *steps, *passed;
    double *points, *tangents;
    unsigned char* met_from_behind;
};

namespace {

/* ---- vectors ---- */

/* Product of two vectors in terms of a scale. */
double product(const double* a, const double* b, const double* scale, casadi_int n)
{
    double sum = 0;
    for (casadi_int k = 0; k < n; k++) sum += (a[k] / scale[k]) * (b[k] / scale[k]);
    return sum;
}

double size_of(const double* a, const double* scale, casadi_int n) { return sqrt(product(a, a, scale, n)); }

/* ---- branches ---- */

/* An arclength step that is under way. */
struct Arc {
    casadi_int next; /* that waits for the same kernel */
    casadi_int level, corrections, tries;
    bool easy, held; /* the latter: the point is on the branch, and its tangent is waited for */
    double length, size, cosine;
    double *y, *across, *turned, *matrix;
    casadi_int* pivot;
};

class Arcs {
public:
    Arcs(const Course& course, const Heads& heads, casadi_int n, casadi_int tries)
        : course(course), heads(heads), n(n), m(course.n_unknowns + 1), tries(tries), queues(2 * course.n_levels)
    {
        const casadi_int own = m * (m + 3);
        arcs = (Arc*) malloc((size_t) (n + 1) * sizeof(Arc));
        data = (double*) malloc((size_t) ((n + 1) * own) * sizeof(double));
        pivots = (casadi_int*) malloc((size_t) ((n + 1) * m) * sizeof(casadi_int));
        first = (casadi_int*) malloc((size_t) queues * sizeof(casadi_int));
        waiting = (casadi_int*) calloc((size_t) queues, sizeof(casadi_int));
        ready = arcs && data && pivots && first && waiting;
        for (casadi_int i = 0; ready && i < n; i++) {
            Arc& arc = arcs[i];
            arc.tries = 0;
            arc.y = data + i * own;
            arc.across = arc.y + m;
            arc.turned = arc.across + m;
            arc.matrix = arc.turned + m;
            arc.pivot = pivots + i * m;
        }
        scratch = data + n * own;
    }

    ~Arcs()
    {
        free(arcs); free(data); free(pivots); free(first); free(waiting);
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
    const Course& course;
    const Heads& heads;
    const casadi_int n, m, tries, queues;
    Arc* arcs;
    double *data, *scratch; /* the latter of size m (m + 3) */
    casadi_int *pivots, *first, *waiting;
    bool ready;

    Arcs(const Arcs&);
    Arcs& operator=(const Arcs&);

    /* Evaluate the kernel of a queue for up to `LANES` that wait in it, and go on with each. */
    int serve(casadi_int q)
    {
        const casadi_int nu = course.n_unknowns, level = q / 2;
        const bool along = q % 2 == 0;
        const casadi_int in_size[] = {nu, course.n_params, course.n_params}, out_size[] = {nu * nu, nu, nu};
        Call call(along ? course.jacobian_along[level] : course.residual[level], along ? 3 : 2, in_size, along ? 3 : 1,
            along ? out_size : out_size + 1);
        if (!call.ready) return 1;
        casadi_int served[LANES];
        int used = 0;
        for (; used < LANES && waiting[q]; used++, waiting[q]--) {
            served[used] = first[q];
            first[q] = arcs[first[q]].next;
        }
        for (int lane = 0; lane < LANES; lane++) {
            const casadi_int i = served[lane < used ? lane : used - 1]; /* others repeat the last */
            const double *const y = arcs[i].y, *const p = course.params + heads.branch[i] * course.n_params,
                         *const d = course.direction + heads.branch[i] * course.n_params;
            put(y, nu, call.in[0], lane);
            for (casadi_int k = 0; k < course.n_params; k++) call.in[1][k].v[lane] = (Real) (p[k] + y[nu] * d[k]);
            if (along) put(d, course.n_params, call.in[2], lane);
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
        const casadi_int q = 2 * arcs[i].level + (along ? 0 : 1);
        arcs[i].next = first[q];
        first[q] = i;
        waiting[q]++;
    }

    /* Begin the next arclength step, if there is one. */
    void go_on(casadi_int i)
    {
        Arc& arc = arcs[i];
        if (arc.tries++ == tries || !(heads.ds[i] >= course.ds_min) || heads.steps[i] >= course.max_steps) return;
        const double *const x = heads.x + i * m, *const tangent = heads.tangent + i * m,
                     *const bend = heads.bend + i * m;
        const double s = x[m - 1], slope = tangent[m - 1];
        const double left = slope > 0 ? (1 - s) / slope : slope < 0 ? -s / slope : INFINITY;
        bool at_end = heads.ds[i] >= left;
        arc.length = at_end ? left : heads.ds[i];
        for (casadi_int k = 0; k < m; k++) {
            arc.y[k] = x[k] + arc.length * tangent[k] + 0.5 * arc.length * arc.length * bend[k];
            arc.across[k] = tangent[k] / (course.scale[k] * course.scale[k]);
        }
        double& there = arc.y[m - 1];
        const double end = at_end ? slope > 0 : there > 0.5;
        at_end |= there < 0 || there > 1;
        if (at_end) {
            there = end;
            for (casadi_int k = 0; k < m; k++) arc.across[k] = k == m - 1;
        }
        const double mode = course.modes[heads.branch[i] * course.n_modes
            + (there > 0 ? there < 1 ? (casadi_int) (there * course.n_modes) : course.n_modes - 1 : 0)];
        double phase = mode * fabs(arc.y[m - 2]);
        if (!(phase < INFINITY)) phase = 0; /* no resolution helps */
        for (arc.level = 0; arc.level < course.n_levels - 1 && course.largest_phase[arc.level] < phase;) arc.level++;
        arc.held = false;
        wait(i, true);
    }

    void linearised(casadi_int i, Call& call, int lane)
    {
        Arc& arc = arcs[i];
        const casadi_int nu = m - 1;
        const double* const tangent = heads.tangent + i * m;
        double* const matrix = arc.matrix;
        for (casadi_int r = 0; r < nu; r++) {
            for (casadi_int k = 0; k < nu; k++) matrix[r + k * m] = call.out[0][r + k * nu].v[lane];
            matrix[r + nu * m] = call.out[1][r].v[lane];
        }
        turn(arc, tangent);
        for (casadi_int k = 0; k < m; k++) matrix[nu + k * m] = arc.across[k];
        factorise(matrix, arc.pivot, m);
        const double size = correct(arc, call.out[2], lane);
        if (arc.held) {
            finish(i, true);
            return;
        }
        arc.size = size;
        arc.cosine = product(arc.turned, tangent, course.scale, m);
        arc.corrections = 0;
        if (!(size < course.correction_ratio * arc.length && arc.cosine > course.min_tangent_cosine)) finish(i, false);
        else if (size < allowed(arc)) {
            arc.easy = true;
            hold(i);
        } else if (course.max_corrections > 0) wait(i, false);
        else finish(i, false);
    }

    void corrected(casadi_int i, const Lanes* residual, int lane)
    {
        Arc& arc = arcs[i];
        const double size = correct(arc, residual, lane);
        arc.corrections++;
        if (size < allowed(arc)) {
            arc.easy = arc.corrections < course.max_corrections;
            hold(i);
        } else if (size < course.contraction * arc.size && arc.corrections < course.max_corrections) {
            arc.size = size;
            wait(i, false);
        } else finish(i, false);
    }

    /* A point on the branch: its tangent must be known, too. */
    void hold(casadi_int i)
    {
        if (arcs[i].cosine < course.sharp) {
            arcs[i].held = true;
            wait(i, true);
        } else finish(i, true);
    }

    /* Where steps are short, points must be as exact as these are short. */
    double allowed(const Arc& arc) const { return fmin(course.tolerance, course.short_correction * arc.length); }

    /* The unit tangent, on the side of another one. */
    void turn(Arc& arc, const double* ahead)
    {
        double* const matrix = scratch;
        for (casadi_int k = 0; k < m * m; k++) matrix[k] = arc.matrix[k];
        for (casadi_int k = 0; k < m; k++) {
            matrix[m - 1 + k * m] = ahead[k] / (course.scale[k] * course.scale[k]);
            arc.turned[k] = k == m - 1;
        }
        factorise(matrix, arc.pivot, m);
        solve_factorised(matrix, arc.pivot, arc.turned, m);
        const double length = size_of(arc.turned, course.scale, m);
        for (casadi_int k = 0; k < m; k++) arc.turned[k] /= length;
    }

    /* Newton's correction of the point with the factorised derivative; its length. */
    double correct(Arc& arc, const Lanes* residual, int lane)
    {
        double* const change = scratch;
        for (casadi_int k = 0; k < m - 1; k++) change[k] = -residual[k].v[lane];
        change[m - 1] = 0;
        solve_factorised(arc.matrix, arc.pivot, change, m);
        for (casadi_int k = 0; k < m; k++) arc.y[k] += change[k];
        return size_of(change, course.scale, m);
    }

    /* How far sideways an arclength step leads, in terms of the mean of the tangents at its ends. */
    double led_sideways(const Arc& arc, const double* x, const double* tangent)
    {
        double *const way = scratch, *const mean = scratch + m;
        for (casadi_int k = 0; k < m; k++) {
            way[k] = arc.y[k] - x[k];
            mean[k] = tangent[k] + arc.turned[k];
        }
        const double ratio = size_of(way, course.scale, m) / size_of(mean, course.scale, m);
        for (casadi_int k = 0; k < m; k++) way[k] -= ratio * mean[k];
        return size_of(way, course.scale, m);
    }

    /* End an arclength step: get on if its point is good, and choose the next one. */
    void finish(casadi_int i, bool good)
    {
        Arc& arc = arcs[i];
        double *const x = heads.x + i * m, *const tangent = heads.tangent + i * m, *const bend = heads.bend + i * m;
        good = good && (led_sideways(arc, x, tangent) < course.sideways || arc.length < course.telling);
        heads.steps[i]++;
        if (!good) {
            heads.ds[i] = fmin(course.step_shrink * heads.ds[i], course.ds_max);
            go_on(i);
            return;
        }
        const double period = arc.y[m - 2], s = arc.y[m - 1];
        const bool ended = !(period > course.shortest && period <= course.longest) || s <= 0 || s >= 1;
        const bool stopped = stops(i);
        const double length = distance(arc.y, x);
        for (casadi_int k = 0; k < m; k++) {
            bend[k] = (arc.turned[k] - tangent[k]) / length;
            x[k] = arc.y[k];
            tangent[k] = arc.turned[k];
        }
        double* const to = heads.points + (i * tries + heads.passed[i]) * m;
        for (casadi_int k = 0; k < m; k++) to[k] = x[k];
        double* const along = heads.tangents + (i * tries + heads.passed[i]) * m;
        for (casadi_int k = 0; k < m; k++) along[k] = tangent[k];
        heads.passed[i]++;
        heads.idle[i] += heads.ds[i];
        const double wanted = sqrt((1 - course.easy_tangent_cosine) / fmax(1 - arc.cosine, 0));
        const double factor = fmin(fmax(wanted, course.step_shrink), arc.easy ? course.step_growth : 1);
        heads.ds[i] = ended || stopped ? 0 : fmin(factor * heads.ds[i], course.ds_max);
        go_on(i);
    }

    double distance(const double* a, const double* b)
    {
        double* const between = scratch;
        for (casadi_int k = 0; k < m; k++) between[k] = a[k] - b[k];
        return size_of(between, course.scale, m);
    }

    /* Whether known points lie on the branch between the ends of the step: see `Stops`. */
    bool stops(casadi_int i)
    {
        const Arc& arc = arcs[i];
        const double *const x = heads.x + i * m, *const tangent = heads.tangent + i * m;
        const double length = distance(arc.y, x), reach = course.bulge * length * course.scale[m - 1];
        const casadi_int line = course.line[heads.branch[i]];
        const double low = key(line, fmin(x[m - 1], arc.y[m - 1]) - reach),
                     high = key(line, fmax(x[m - 1], arc.y[m - 1]) + reach);
        bool met = false;
        for (casadi_int at = first_stop(low); at < course.n_stops && course.stop_key[at] <= high; at++) {
            const double* const stop = course.stop + at * m;
            double part = 0, away = 0;
            for (casadi_int k = 0; k < m; k++) {
                const double off = (stop[k] - x[k]) / course.scale[k];
                part += off * ((arc.y[k] - x[k]) / course.scale[k]);
                away += off * off;
            }
            part /= length * length;
            /* The start itself is at part 0, but for rounding. */
            if (!(part > 1e-9 && part <= 1 && away < 2 * length * length)) continue;
            double apart = 0;
            for (casadi_int k = 0; k < m; k++) {
                const double chord = arc.y[k] - x[k], m0 = length * tangent[k], m1 = length * arc.turned[k];
                const double there = (((m0 + m1 - 2 * chord) * part + 3 * chord - 2 * m0 - m1) * part + m0) * part
                    + x[k];
                apart += (there - stop[k]) / course.scale[k] * ((there - stop[k]) / course.scale[k]);
            }
            if (!(sqrt(apart) < course.on_curve * length)) continue;
            met = true;
            const casadi_int number = course.stop_number[at];
            if (number < course.n_beginnings && product(arc.turned, course.beginning + number * m, course.scale, m) > 0)
                heads.met_from_behind[number] = 1;
        }
        return met;
    }

    /* Numbers that order points by line, then position: `_key` in stops.py. */
    static double key(casadi_int line, double s) { return (double) line + 0.5 * fmin(fmax(s, -0.5), 1.4); }

    casadi_int first_stop(double low) const
    {
        casadi_int begin = 0, end = course.n_stops;
        while (begin < end) {
            const casadi_int middle = (begin + end) / 2;
            if (course.stop_key[middle] < low) begin = middle + 1;
            else end = middle;
        }
        return begin;
    }
};

} /* namespace */

/* The sizes of both structures, for who fills them to compare. */
extern "C" casadi_int lockstep_arcs_size(int heads) { return heads ? sizeof(Heads) : sizeof(Course); }

/* Up to `tries` arclength steps of each of n branches. Returns as lockstep_map. */
extern "C" int lockstep_arcs(const Course* course, const Heads* heads, casadi_int n, casadi_int tries)
{
    Arcs arcs(*course, *heads, n, tries);
    return arcs.run();
}
