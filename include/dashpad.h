#ifndef DASHPAD_H
#define DASHPAD_H
/*
 * The C interface of Dashpad: what other languages call. A case is read, changed and solved; everything that
 * the commands assess, solve-for, fit and pulse answer is asked for as JSON.
 *
 * Handles belong to the caller, who frees each with the function of its name; NULL may be freed. Texts are
 * UTF-8 and end with a 0. A text or an array that a handle returns belongs to the handle and is valid until
 * it is freed or, of a case, changed.
 *
 * Errors: no function ends the program, none throws, and there is no global state. A function that can fail
 * returns NULL or 0 and puts the faults in *faults, all of it at once, if `faults` is not NULL; on success
 * *faults is NULL.
 *
 * Threads: different handles may be used at the same time; one solver or one case that changes is for one
 * thread at a time.
 *
 * Units: SI throughout, in plain numbers; texts may have any unit that case files know ("30 mm", "15 mph").
 *
 * Example:
 *
 *     dashpad_faults *faults;
 *     dashpad_case *drop = dashpad_case_read("drop.toml", NULL, "materials", &faults);
 *     if (!drop) fputs(dashpad_faults_text(faults), stderr);
 *     dashpad_case_set(drop, "pad.thickness", "30 mm", &faults);
 *     dashpad_solver *solver = dashpad_solver_new();
 *     dashpad_result *result = dashpad_solve(solver, drop, 0, &faults);
 *     printf("%g m/s2\n", dashpad_result_figure(result, "peak_acceleration"));
 */

#include <stddef.h>

#if defined(__GNUC__)
#define DASHPAD_API __attribute__((visibility("default")))
#else
#define DASHPAD_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this interface; it grows when a function changes or goes. */
#define DASHPAD_INTERFACE 1
/* DASHPAD_INTERFACE of the library that runs. */
DASHPAD_API int dashpad_interface(void);
/* The version of the program, such as "0.2.0". */
DASHPAD_API const char* dashpad_version(void);

/* ---- Faults ---- */

typedef struct dashpad_faults dashpad_faults;

/* A fault: its place, the value found there, and the rule that it breaks. */
typedef struct dashpad_fault {
  const char* file;  /* "" if unknown */
  int line;          /* from 1; 0 if unknown */
  const char* key;   /* "pad.thickness"; "" if it is about more */
  const char* value; /* as written; "" if there is none */
  const char* rule;  /* what would be right */
  const char* text;  /* all of it in one line */
} dashpad_fault;

DASHPAD_API size_t dashpad_faults_size(const dashpad_faults* faults);
/* `i` < dashpad_faults_size(); beyond it, empty texts. */
DASHPAD_API dashpad_fault dashpad_faults_at(const dashpad_faults* faults, size_t i);
/* All in one text, a line each. */
DASHPAD_API const char* dashpad_faults_text(const dashpad_faults* faults);
DASHPAD_API void dashpad_faults_free(dashpad_faults* faults);

/* ---- Cases ---- */

typedef struct dashpad_case dashpad_case;

/*
 * Reads and checks a case file. With `text` it is read in place of the file, which then gives the name in
 * faults and the folder in which other files are found. `materials` is the folder of the cards that the case
 * names.
 */
DASHPAD_API dashpad_case* dashpad_case_read(const char* file, const char* text, const char* materials,
                                            dashpad_faults** faults);
DASHPAD_API dashpad_case* dashpad_case_copy(const dashpad_case* given);
DASHPAD_API void dashpad_case_free(dashpad_case* given);

/*
 * Sets a key of the case as `dashpad run --set` does: "pad.thickness" to "30 mm", "pad.material" to "vn600".
 * Returns whether the changed case is valid; if it is not, the case stays as it was.
 */
DASHPAD_API int dashpad_case_set(dashpad_case* given, const char* key, const char* value,
                                 dashpad_faults** faults);
/* The same for a number in SI: of the keys that dashpad_case_key() lists, and much faster for those. */
DASHPAD_API int dashpad_case_set_number(dashpad_case* given, const char* key, double value,
                                        dashpad_faults** faults);
/* A number of the case in SI; NaN if the case does not have it. */
DASHPAD_API double dashpad_case_number(const dashpad_case* given, const char* key);

/* The numbers that a case has, with its nose, foam and support. */
DASHPAD_API size_t dashpad_case_size(const dashpad_case* given);
/* Key and SI unit ("1" for a pure number) of the i-th; NULL beyond the last. */
DASHPAD_API const char* dashpad_case_key(const dashpad_case* given, size_t i);
DASHPAD_API const char* dashpad_case_unit(const dashpad_case* given, size_t i);
/* The case as a case file in SI that needs no other files; NULL if memory is short. */
DASHPAD_API const char* dashpad_case_toml(dashpad_case* given);

/* ---- Solving ---- */

/* The memory of a solver, which grows with use and serves one solution after the other. */
typedef struct dashpad_solver dashpad_solver;
/* NULL if memory is short. */
DASHPAD_API dashpad_solver* dashpad_solver_new(void);
DASHPAD_API void dashpad_solver_free(dashpad_solver* solver);

typedef struct dashpad_result dashpad_result;
/*
 * Solves the case to a relative error, from 1e-8 to 1e-2; 0: to that of the case. Of repeated blows the
 * result is that of the last. A result is there even if the tolerance is missed: see
 * dashpad_result_is_trustworthy().
 */
DASHPAD_API dashpad_result* dashpad_solve(dashpad_solver* solver, const dashpad_case* given, double tolerance,
                                          dashpad_faults** faults);
DASHPAD_API void dashpad_result_free(dashpad_result* result);

/* "released", "bottomed out", "time limit", "tolerance not met", "at rest". */
DASHPAD_API const char* dashpad_result_status(const dashpad_result* result);
/* Whether the figures may be relied on to the tolerance. */
DASHPAD_API int dashpad_result_is_trustworthy(const dashpad_result* result);

/*
 * A figure in SI by its key in studies ("peak_acceleration", "hic15", "rebound_speed"); NaN if the impact
 * does not have it or there is no such figure.
 */
DASHPAD_API double dashpad_result_figure(dashpad_result* result, const char* key);
/* All figures: how many, and key, SI unit and title of the i-th; NULL beyond the last. */
DASHPAD_API size_t dashpad_figures_size(void);
DASHPAD_API const char* dashpad_figure_key(size_t i);
DASHPAD_API const char* dashpad_figure_unit(size_t i);
DASHPAD_API const char* dashpad_figure_title(size_t i);

/* The flags of the result: its reservations. A line that begins with the name of the flag; NULL beyond the
 * last. */
DASHPAD_API size_t dashpad_result_flags_size(dashpad_result* result);
DASHPAD_API const char* dashpad_result_flag(dashpad_result* result, size_t i);

/*
 * A column over time, in SI, with the signs of docs/theory.md: "time", "force", "acceleration", "velocity",
 * "motion", "penetration", "support_deflection", "contact_radius", "axis_strain", and where there is one
 * "transmitted_force", "body_motion", "pad_force" and "layer_strain_1" on. `size` entries; NULL and 0 if the
 * impact has no such column.
 */
DASHPAD_API const double* dashpad_result_history(const dashpad_result* result, const char* column,
                                                 size_t* size);

/* The name of the i-th column that an impact may have, but for those of layers; NULL beyond the last. */
DASHPAD_API const char* dashpad_history_key(size_t i);

/* The result as `dashpad run --no-intervals --json` writes it; NULL if memory is short. */
DASHPAD_API const char* dashpad_result_json(dashpad_result* result);

/* ---- Many impacts ---- */

/* Told of the rows that are done, by one thread at a time; returns whether to go on. */
typedef int (*dashpad_progress)(void* context, size_t done, size_t rows);

/* A case with some of its numbers from a table, one impact a row. */
typedef struct dashpad_batch {
  size_t rows;
  const char* const* keys; /* keys that studies may vary: "impactor.speed", "impactor.drop_height" */
  size_t keys_size;
  const double* values;       /* rows times keys_size, one row after the other, in SI */
  const char* const* figures; /* keys of figures, such as "hic15" */
  size_t figures_size;
  double tolerance;          /* 0: that of the case */
  int threads;               /* 0: one a core */
  dashpad_progress progress; /* may be NULL */
  void* context;             /* handed to progress */
  unsigned char* flags;      /* may be NULL; takes for each row a sum of DASHPAD_EXTRAPOLATED_STRAIN ... */
} dashpad_batch;

/* The foam was strained further, or faster, than it was tested; the pad was compressed fully. */
#define DASHPAD_EXTRAPOLATED_STRAIN 1
#define DASHPAD_EXTRAPOLATED_RATE 2
#define DASHPAD_BOTTOMED 4

/*
 * Solves the rows on many threads. `results` takes rows times figures_size numbers in SI, one row after the
 * other, NaN where an impact does not have the figure; the numbers are those of a study with these rows.
 * `statuses` and `errors`, each of which may be NULL, take the status of each row (dashpad_status_name()) and
 * the largest estimated relative error of its figures. Rows whose values make no valid case are faults, and
 * nothing is solved. Returns 1 if all rows are done, and 0 with no fault if progress() ended it: rows that
 * were not reached are NaN, and "not run".
 */
DASHPAD_API int dashpad_solve_batch(const dashpad_case* given, const dashpad_batch* batch, double* results,
                                    unsigned char* statuses, double* errors, dashpad_faults** faults);
/* "released" and so on; NULL for an unknown number. */
DASHPAD_API const char* dashpad_status_name(unsigned char status);

/* ---- Everything else ---- */

/*
 * The answer to a request, both JSON: {"do": "solve" | "solve-for" | "fit" | "pulse" | "read" | "list", ...}
 * as src/live/answer.hpp lists them. `given` may be NULL; else the request is about that case, with its
 * changes and the folder of its cards in place of `materials`. What cannot be answered is {"faults": [...]}.
 * `standards` is the folder of standards. Free it with dashpad_text_free(); NULL if memory is short.
 */
DASHPAD_API char* dashpad_answer(const char* request, const dashpad_case* given, const char* materials,
                                 const char* standards);
DASHPAD_API void dashpad_text_free(char* text);

#ifdef __cplusplus
}
#endif
#endif
