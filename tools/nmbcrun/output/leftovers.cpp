// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/leftovers.hpp"

#include <fstream>
#include <system_error>

#include "generator/support/posix_file.hpp"

namespace nmbcrun {

bool begins_with(const std::filesystem::path& path, std::string_view beginning) {
    std::string found(beginning.size(), '\0');
    std::ifstream stream(path, std::ios::binary);
    return stream.read(found.data(), std::streamsize(found.size())) && found == beginning;
}

void remove_leftovers(const std::filesystem::path& path, std::string_view beginning,
                      const std::function<bool(const std::string&)>& wanted) {
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    const std::string temporary = path.filename().string() + ".new-";
    std::error_code error;  // a folder that cannot be listed keeps what it has
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with(temporary) && !wanted(name) &&
            (beginning.empty() || begins_with(entry->path(), beginning))) {
            nmbcgen::remove_unless_open(entry->path());
        }
    }
}

}  // namespace nmbcrun
