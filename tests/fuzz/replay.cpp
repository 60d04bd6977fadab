// The main program of a fuzz target where there is no libFuzzer: every file of a corpus, then the same
// mutations of them every time.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

constexpr std::size_t max_changes = 4;

void try_input(const std::string& input) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

std::vector<std::string> corpus_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::ranges::sort(files);  // the order of a folder is another on every machine
  std::vector<std::string> corpus;
  for (const fs::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return corpus;
}

/// Of std::mt19937_64 the standard fixes every number; of its distributions it does not.
class Mutator {
 public:
  explicit Mutator(const std::vector<std::string>& corpus) : corpus_(corpus) {}

  std::string next() {
    std::string text = any_seed();
    for (std::size_t changes = 1 + below(max_changes); changes > 0; --changes) change(text);
    return text;
  }

 private:
  std::size_t below(std::size_t end) {
    return static_cast<std::size_t>(random_() % std::max<std::size_t>(end, 1));
  }
  const std::string& any_seed() { return corpus_[below(corpus_.size())]; }
  char any_character() {
    constexpr std::string_view telling = "\n\r\t \"'.,;:#=[]{}()/\\-+%0189eE\0\x1b\xff\xc2"sv;
    return below(2) == 0 ? telling[below(telling.size())] : static_cast<char>(below(256));
  }

  void change(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = below(std::min<std::size_t>(text.size() - at, 40) + 1);
    switch (below(6)) {
      case 0:
        if (at < text.size()) text[at] = any_character();
        break;
      case 1: text.insert(at, 1, any_character()); break;
      case 2: text.erase(at, length); break;
      case 3: text.insert(below(text.size() + 1), text.substr(at, length)); break;
      case 4: {
        const std::string& other = any_seed();
        text.insert(at, other.substr(below(other.size() + 1), 40));
        break;
      }
      default: text.resize(at);
    }
  }

  const std::vector<std::string>& corpus_;
  std::mt19937_64 random_{1986};
};

}  // namespace

int main(int count, char** arguments) {
  const int mutations = count == 3 ? std::atoi(arguments[2]) : -1;
  if (mutations < 0) {
    std::fprintf(stderr, "usage: %s FOLDER MUTATIONS\n", arguments[0]);
    return 2;
  }
  const std::vector<std::string> corpus = corpus_in(arguments[1]);
  if (corpus.empty()) {
    std::fprintf(stderr, "%s holds no file\n", arguments[1]);
    return 2;
  }
  try_input("");
  for (const std::string& input : corpus) try_input(input);
  Mutator mutator(corpus);
  for (int i = 0; i < mutations; ++i) try_input(mutator.next());
  std::printf("%zu files, %d mutations\n", corpus.size(), mutations);
}
