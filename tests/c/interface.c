/* The C interface from C: what it answers is what the command answers, and no mistake of its caller ends the
 * program. */

#define _POSIX_C_SOURCE 200809L /* popen() */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dashpad.h"

static int failed = 0;

#define EXPECT(condition)                                                      \
  do {                                                                         \
    if (!(condition)) {                                                        \
      fprintf(stderr, "%s:%d: Failure: %s\n", __FILE__, __LINE__, #condition); \
      failed = 1;                                                              \
    }                                                                          \
  } while (0)

static const char* drop =
    "[impactor]\nmass = \"5 kg\"\nradius = \"80 mm\"\nspeed = \"4 m/s\"\n"
    "[pad]\nthickness = \"40 mm\"\nmaterial = \"vn600\"\n[support]\ntype = \"rigid\"\n";

static char materials[4096], standards[4096];

static dashpad_case* read_drop(void) { return dashpad_case_read("drop.toml", drop, materials, NULL); }

static void tells_versions(void) {
  EXPECT(dashpad_interface() == DASHPAD_INTERFACE);
  EXPECT(strchr(dashpad_version(), '.') != NULL);
}

static void solves_a_case(void) {
  dashpad_faults* faults = (dashpad_faults*)&failed;
  dashpad_case* given = dashpad_case_read("drop.toml", drop, materials, &faults);
  EXPECT(given != NULL && faults == NULL);
  EXPECT(dashpad_case_number(given, "pad.thickness") == 0.04);
  EXPECT(isnan(dashpad_case_number(given, "pad.colour")));
  dashpad_solver* solver = dashpad_solver_new();
  dashpad_result* result = dashpad_solve(solver, given, 0, &faults);
  EXPECT(result != NULL && faults == NULL);
  EXPECT(strcmp(dashpad_result_status(result), "released") == 0);
  EXPECT(dashpad_result_is_trustworthy(result));
  const double peak = dashpad_result_figure(result, "peak_acceleration");
  EXPECT(peak > 100 && peak < 1000);
  EXPECT(isnan(dashpad_result_figure(result, "peak_colour")));
  EXPECT(dashpad_result_figure(result, "hic15") > 0);

  /* The force over time, without a copy: its largest value is close to the peak, which is read between the
   * steps. */
  size_t size = 0, of_time = 0;
  const double* force = dashpad_result_history(result, "force", &size);
  EXPECT(dashpad_result_history(result, "time", &of_time) != NULL && of_time == size && size > 20);
  double largest = 0;
  for (size_t i = 0; i < size; ++i) largest = force[i] > largest ? force[i] : largest;
  EXPECT(fabs(largest / (5 * peak) - 1) < 1e-3);
  EXPECT(dashpad_result_history(result, "layer_strain_1", &size) == NULL && size == 0);
  EXPECT(dashpad_result_history(result, "layer_strain_99999999999999999999", NULL) == NULL);
  EXPECT(strstr(dashpad_result_json(result), "\"peak_acceleration_g\"") != NULL);
  const size_t flags = dashpad_result_flags_size(result);
  EXPECT(dashpad_result_flag(result, flags) == NULL &&
         (flags == 0 || dashpad_result_flag(result, 0) != NULL));

  /* A result outlives its case and its solver, and the next solution. */
  dashpad_result* again = dashpad_solve(solver, given, 1e-3, &faults);
  EXPECT(fabs(dashpad_result_figure(again, "peak_acceleration") / peak - 1) < 1e-3);
  dashpad_case_free(given);
  dashpad_solver_free(solver);
  EXPECT(dashpad_result_figure(result, "peak_acceleration") == peak);
  EXPECT(force == dashpad_result_history(result, "force", NULL));
  dashpad_result_free(again);
  dashpad_result_free(result);
}

static void changes_a_case(void) {
  dashpad_faults* faults = NULL;
  dashpad_case* given = read_drop();
  dashpad_case* copy = dashpad_case_copy(given);
  EXPECT(dashpad_case_set(given, "pad.thickness", "2 in", &faults) && faults == NULL);
  EXPECT(dashpad_case_number(given, "pad.thickness") == 0.0508);
  EXPECT(dashpad_case_set_number(given, "impactor.speed", 6.5, &faults));
  EXPECT(dashpad_case_set(given, "pad.material", "eps-29", &faults));
  /* What was set before is still there. */
  EXPECT(dashpad_case_number(given, "impactor.speed") == 6.5);
  EXPECT(dashpad_case_number(given, "pad.thickness") == 0.0508);
  EXPECT(dashpad_case_number(copy, "impactor.speed") == 4);
  EXPECT(dashpad_case_number(copy, "pad.thickness") == 0.04);
  /* A number of one foam does not hinder the next. */
  EXPECT(dashpad_case_set(copy, "pad.parameters.recoil", "0.5", &faults));
  EXPECT(dashpad_case_set(copy, "pad.material", "eps-29", &faults));
  /* A drop height stands in place of a speed. */
  EXPECT(dashpad_case_set(copy, "impactor.drop_height", "1 m", &faults));
  EXPECT(dashpad_case_set_number(copy, "impactor.speed", 3, &faults));
  EXPECT(dashpad_case_set(copy, "pad.thickness", "30 mm", &faults) &&
         dashpad_case_number(copy, "impactor.speed") == 3);

  int has_speed = 0;
  for (size_t i = 0; i < dashpad_case_size(given); ++i)
    has_speed |= strcmp(dashpad_case_key(given, i), "impactor.speed") == 0 &&
                 strcmp(dashpad_case_unit(given, i), "m/s") == 0;
  EXPECT(has_speed);
  EXPECT(dashpad_case_key(given, dashpad_case_size(given)) == NULL);

  /* The case as a file is the same case. */
  dashpad_case* whole = dashpad_case_read("whole.toml", dashpad_case_toml(given), "", &faults);
  EXPECT(whole != NULL && dashpad_case_number(whole, "impactor.speed") == 6.5);
  dashpad_case_free(whole);
  dashpad_case_free(copy);
  dashpad_case_free(given);
}

static void tells_all_that_is_wrong(void) {
  dashpad_faults* faults = NULL;
  const char* bad =
      "[impactor]\nmass = \"5 kpg\"\nradius = \"-80 mm\"\nspeed = \"4 m/s\"\n[pad]\nthickness = \"40 mm\"\n"
      "material = \"vn601\"\n[support]\ntype = \"rigid\"\n";
  EXPECT(dashpad_case_read("bad.toml", bad, materials, &faults) == NULL);
  EXPECT(dashpad_faults_size(faults) == 3);
  EXPECT(strcmp(dashpad_faults_at(faults, 0).file, "bad.toml") == 0);
  EXPECT(dashpad_faults_at(faults, 0).line == 2);
  EXPECT(strcmp(dashpad_faults_at(faults, 0).key, "impactor.mass") == 0);
  EXPECT(strstr(dashpad_faults_text(faults), "vn600") != NULL);
  EXPECT(strcmp(dashpad_faults_at(faults, 99).text, "") == 0);
  dashpad_faults_free(faults);
  EXPECT(dashpad_case_read("/nowhere/drop.toml", NULL, materials, &faults) == NULL &&
         dashpad_faults_size(faults) == 1);
  dashpad_faults_free(faults);

  dashpad_case* given = read_drop();
  const char* values[] = {"", "-3 mm", "3 kg", "NaN", "1e400 mm", "0"};
  for (size_t i = 0; i < sizeof values / sizeof *values; ++i) {
    EXPECT(!dashpad_case_set(given, "pad.thickness", values[i], &faults) && dashpad_faults_size(faults) >= 1);
    dashpad_faults_free(faults);
  }
  const double numbers[] = {-1, 0, NAN, INFINITY, 1e300};
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; ++i) {
    EXPECT(!dashpad_case_set_number(given, "pad.thickness", numbers[i], &faults));
    EXPECT(dashpad_faults_size(faults) >= 1);
    dashpad_faults_free(faults);
  }
  EXPECT(!dashpad_case_set_number(given, "pad.colour", 3, &faults) && dashpad_faults_size(faults) == 1);
  dashpad_faults_free(faults);
  /* The case is as it was. */
  EXPECT(dashpad_case_number(given, "pad.thickness") == 0.04);

  dashpad_solver* solver = dashpad_solver_new();
  const double tolerances[] = {-1, NAN, 1, 1e-12};
  for (size_t i = 0; i < sizeof tolerances / sizeof *tolerances; ++i) {
    EXPECT(dashpad_solve(solver, given, tolerances[i], &faults) == NULL && dashpad_faults_size(faults) == 1);
    EXPECT(strcmp(dashpad_faults_at(faults, 0).key, "tolerance") == 0);
    dashpad_faults_free(faults);
  }
  dashpad_solver_free(solver);
  dashpad_case_free(given);
}

static void survives_null(void) {
  dashpad_faults* faults = NULL;
  EXPECT(dashpad_case_read(NULL, NULL, NULL, &faults) == NULL && faults != NULL);
  dashpad_faults_free(faults);
  EXPECT(dashpad_case_copy(NULL) == NULL && dashpad_case_toml(NULL) == NULL && dashpad_case_size(NULL) == 0);
  EXPECT(!dashpad_case_set(NULL, "pad.thickness", "3 mm", NULL) &&
         !dashpad_case_set_number(NULL, NULL, 3, NULL));
  EXPECT(isnan(dashpad_case_number(NULL, NULL)) && dashpad_case_key(NULL, 0) == NULL);
  EXPECT(dashpad_solve(NULL, NULL, 0, &faults) == NULL && dashpad_faults_size(faults) == 1);
  dashpad_faults_free(faults);
  EXPECT(isnan(dashpad_result_figure(NULL, "hic15")) && dashpad_result_history(NULL, "force", NULL) == NULL);
  EXPECT(dashpad_result_json(NULL) == NULL && dashpad_result_flag(NULL, 0) == NULL);
  EXPECT(!dashpad_result_is_trustworthy(NULL) && dashpad_result_status(NULL) != NULL);
  EXPECT(dashpad_faults_size(NULL) == 0 && strcmp(dashpad_faults_text(NULL), "") == 0);
  dashpad_case* given = read_drop();
  EXPECT(!dashpad_case_set(given, NULL, NULL, NULL) && !dashpad_case_set_number(given, NULL, 3, NULL));
  EXPECT(dashpad_solve(NULL, given, 0, NULL) == NULL);
  dashpad_case_free(given);
  dashpad_case_free(NULL), dashpad_solver_free(NULL), dashpad_result_free(NULL), dashpad_faults_free(NULL),
      dashpad_text_free(NULL);
}

static int count_calls(void* context, size_t done, size_t rows) {
  size_t* const last = context;
  EXPECT(done > *last && done <= rows);
  *last = done;
  return 1;
}
static int stop_at_once(void* context, size_t done, size_t rows) {
  (void)context, (void)done, (void)rows;
  return 0;
}

static void solves_batches(void) {
  enum { rows = 200 };
  static double values[rows][2], results[rows][2], errors[rows];
  static unsigned char statuses[rows], flags[rows];
  for (size_t i = 0; i < rows; ++i)
    values[i][0] = 3 + 0.01 * (double)i, values[i][1] = 0.03 + 1e-4 * (double)i;
  const char* const keys[] = {"impactor.speed", "pad.thickness"};
  const char* const figures[] = {"peak_acceleration", "hic15"};
  size_t done = 0;
  dashpad_batch batch = {rows, keys, 2, &values[0][0], figures, 2, 1e-3, 2, count_calls, &done, flags};
  dashpad_faults* faults = NULL;
  dashpad_case* const given = read_drop();
  EXPECT(dashpad_solve_batch(given, &batch, &results[0][0], statuses, errors, &faults) && faults == NULL);
  EXPECT(done == rows);

  /* The numbers of each impact by itself. */
  dashpad_solver* const solver = dashpad_solver_new();
  for (size_t i = 0; i < rows; i += 50) {
    dashpad_case_set_number(given, keys[0], values[i][0], NULL);
    dashpad_case_set_number(given, keys[1], values[i][1], NULL);
    dashpad_result* const result = dashpad_solve(solver, given, 1e-3, NULL);
    EXPECT(dashpad_result_figure(result, figures[0]) == results[i][0]);
    EXPECT(dashpad_result_figure(result, figures[1]) == results[i][1]);
    EXPECT(strcmp(dashpad_result_status(result), dashpad_status_name(statuses[i])) == 0);
    EXPECT(errors[i] > 0 && errors[i] < 0.01);
    dashpad_result_free(result);
  }
  dashpad_solver_free(solver);

  batch.progress = stop_at_once;
  EXPECT(!dashpad_solve_batch(given, &batch, &results[0][0], statuses, NULL, &faults) && faults == NULL);
  EXPECT(isnan(results[rows - 1][0]) && strcmp(dashpad_status_name(statuses[rows - 1]), "not run") == 0);

  /* What is wrong, and nothing is solved. */
  batch.progress = NULL;
  values[7][1] = -1;
  EXPECT(!dashpad_solve_batch(given, &batch, &results[0][0], NULL, NULL, &faults) &&
         dashpad_faults_size(faults) == 1);
  dashpad_faults_free(faults);
  values[7][1] = NAN;
  EXPECT(!dashpad_solve_batch(given, &batch, &results[0][0], NULL, NULL, &faults) &&
         dashpad_faults_size(faults) >= 1);
  dashpad_faults_free(faults);
  const char* const bad_keys[] = {"impactor.sped", "pad.material"};
  const char* const bad_figures[] = {"hic16", NULL};
  batch.keys = bad_keys, batch.figures = bad_figures;
  EXPECT(!dashpad_solve_batch(given, &batch, &results[0][0], NULL, NULL, &faults) &&
         dashpad_faults_size(faults) == 4);
  dashpad_faults_free(faults);
  batch.values = NULL;
  EXPECT(!dashpad_solve_batch(given, &batch, &results[0][0], NULL, NULL, &faults) &&
         dashpad_faults_size(faults) == 1);
  dashpad_faults_free(faults);
  EXPECT(!dashpad_solve_batch(given, NULL, NULL, NULL, NULL, &faults) && dashpad_faults_size(faults) == 1);
  dashpad_faults_free(faults);
  EXPECT(dashpad_status_name(99) == NULL);
  dashpad_case_free(given);
}

static void lists_figures(void) {
  EXPECT(strcmp(dashpad_history_key(0), "time") == 0 && dashpad_history_key(99) == NULL);
  EXPECT(dashpad_figures_size() > 10 && dashpad_figure_key(dashpad_figures_size()) == NULL);
  for (size_t i = 0; i < dashpad_figures_size(); ++i)
    EXPECT(*dashpad_figure_key(i) && *dashpad_figure_unit(i) && *dashpad_figure_title(i));
}

static void answers_requests(void) {
  char* answer = dashpad_answer("{\"do\": \"list\"}", NULL, materials, standards);
  EXPECT(answer != NULL && strstr(answer, "\"vn600\"") != NULL && strstr(answer, "\"en-1078\"") != NULL);
  dashpad_text_free(answer);
  /* Of a case with its changes, by a standard. */
  dashpad_case* const given = read_drop();
  EXPECT(dashpad_case_set(given, "pad.thickness", "50 mm", NULL));
  answer = dashpad_answer("{\"do\": \"solve\", \"standard\": \"en-1078\", \"intervals\": true}", given, NULL,
                          standards);
  EXPECT(strstr(answer, "\"verdict\"") != NULL && strstr(answer, "\"thickness_m\":0.05,") != NULL);
  dashpad_text_free(answer);

  dashpad_case_free(given);

  const char* bad[] = {NULL, "", "{", "[]", "{\"do\": \"fly\"}", "{\"do\": \"solve\"}", "\xff\xfe"};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
    answer = dashpad_answer(bad[i], NULL, materials, standards);
    EXPECT(answer != NULL && strstr(answer, "\"faults\"") != NULL);
    dashpad_text_free(answer);
  }
}

/* Without the line of a key that is not the same each time. */
static void forget(char* json, const char* key) {
  char* const line = strstr(json, key);
  EXPECT(line != NULL);
  if (line != NULL) memmove(line, strchr(line, '\n'), strlen(strchr(line, '\n')) + 1);
}

/* The same text as from the command, so the same numbers to the last bit. */
static void agrees_with_the_command(const char* sources, const char* command) {
  static char line[9000], of_command[1 << 16], own[1 << 16], file[4200];
  snprintf(file, sizeof file, "%s/examples/dashboard-20mph.toml", sources);
  snprintf(line, sizeof line, "'%s' run '%s' --no-intervals --json - 2>/dev/null", command, file);
  FILE* const pipe = popen(line, "r");
  of_command[fread(of_command, 1, sizeof of_command - 1, pipe)] = 0;
  pclose(pipe);
  dashpad_case* const given = dashpad_case_read(file, NULL, materials, NULL);
  dashpad_solver* const solver = dashpad_solver_new();
  dashpad_result* const result = dashpad_solve(solver, given, 0, NULL);
  snprintf(own, sizeof own, "%s", dashpad_result_json(result));
  const char* const keys[] = {"\"wall_time_s\"", "\"commit\""};
  for (size_t i = 0; i < 2; ++i) forget(of_command, keys[i]), forget(own, keys[i]);
  EXPECT(strlen(own) > 1000 && strcmp(own, of_command) == 0);
  dashpad_result_free(result);
  dashpad_solver_free(solver);
  dashpad_case_free(given);
}

/* The folder of the sources, and the command, if it is built. */
int main(int count, char** arguments) {
  if (count < 2) return EXIT_FAILURE;
  snprintf(materials, sizeof materials, "%s/materials", arguments[1]);
  snprintf(standards, sizeof standards, "%s/standards", arguments[1]);
  tells_versions();
  solves_a_case();
  changes_a_case();
  tells_all_that_is_wrong();
  survives_null();
  solves_batches();
  lists_figures();
  answers_requests();
  if (count > 2) agrees_with_the_command(arguments[1], arguments[2]);
  return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
