// The arrows between the rooms of src/, as src/CMakeLists.txt declares them with add_room(): a source
// includes headers of its own folder, of those before it in its room, and of the rooms that its room stands
// on.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "shared/generated_text.hpp"

namespace dashpad::test {
namespace {

namespace fs = std::filesystem;

using Folders = std::set<std::string>;

/// Of each folder, those whose headers it may include.
std::map<std::string, Folders> reach_of_folders() {
  const std::string text = text_of(fs::path(DASHPAD_SOURCE_DIR) / "src" / "CMakeLists.txt");
  const std::regex declaration(R"(\nadd_room\(([^)]*)\))");
  std::map<std::string, Folders> of_room, of_folder;
  for (std::sregex_iterator found(text.begin(), text.end(), declaration), end; found != end; ++found) {
    std::istringstream words((*found)[1].str());
    std::string name, word, keyword;
    words >> name;
    std::vector<std::string> folders;
    Folders reached;
    while (words >> word) {
      if (word == "FOLDERS" || word == "ON" || word == "SOURCES" || word == "LIBRARIES")
        keyword = word;
      else if (keyword == "FOLDERS")
        folders.push_back(word);
      else if (keyword == "ON")
        reached.merge(Folders(of_room.at(word.substr(std::string("dashpad-").size()))));
    }
    for (const std::string& folder : folders) {
      reached.insert(folder);
      of_folder[folder] = reached;
    }
    of_room[name] = reached;
  }
  return of_folder;
}

std::string first_part(const fs::path& path) { return path.begin()->string(); }

TEST(Rooms, IncludeOnlyWhatTheyStandOn) {
  const std::map<std::string, Folders> reach = reach_of_folders();
  const fs::path checkout(DASHPAD_SOURCE_DIR);
  // Those of examples in comments do not begin their lines.
  const std::regex include_line(R"re((?:^|\n)#include "(?:dashpad/)?([^"]+)")re");
  std::size_t seen = 0;
  for (const fs::path& base : {checkout / "src", checkout / "include" / "dashpad"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(base)) {
      const std::string ending = entry.path().extension().string();
      const fs::path place = fs::relative(entry.path(), base);
      if ((ending != ".cpp" && ending != ".hpp") || !place.has_parent_path()) continue;
      ASSERT_TRUE(reach.contains(first_part(place))) << place << " is in no room of src/CMakeLists.txt";
      const std::string text = text_of(entry.path());
      for (std::sregex_iterator found(text.begin(), text.end(), include_line), end; found != end; ++found) {
        const fs::path header((*found)[1].str());
        if (!header.has_parent_path()) continue;  // version.hpp
        ++seen;
        EXPECT_TRUE(reach.at(first_part(place)).contains(first_part(header)))
            << place << " includes " << header;
      }
    }
  EXPECT_GT(seen, 1000u);
}

}  // namespace
}  // namespace dashpad::test
