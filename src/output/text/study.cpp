// The answers of a study for the terminal.

#include <fmt/format.h>

#include "output/text/study_answer.hpp"
#include "output/text/study_tables.hpp"
#include "output/text/study_words.hpp"
#include "output/text/table.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

std::string study_text(const study::StudyAnswers& answers, const UnitSystem& units) {
  std::string text = answers.study.title.empty() ? "Study" : one_line(answers.study.title);
  if (const std::string answer = study_answer(answers, units); !answer.empty()) text += "\n" + answer + ".";
  text += fmt::format("\n\n{} rows, computed by Dashpad {}\n", answers.records.rows.size(),
                      one_line(answers.program));
  for (const std::string& warning : study_warnings(answers)) text += warning + "\n";
  if (answers.records.rows.empty()) return text;
  text += "\n";
  text += plain_text(factor_table(answers, units));
  for (const Table& table : study_tables(answers, units))
    text += "\n" + table.caption + "\n" + plain_text(table);
  return text + "\n" + interval_note(answers) + "\n";
}

}  // namespace dashpad::output
