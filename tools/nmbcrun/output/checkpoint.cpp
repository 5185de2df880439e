// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/checkpoint.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <type_traits>

#include "generator/names/checksum.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/regular_file.hpp"

namespace nmbcrun {
namespace {

// The file: magic, size and checksum of what follows, and that. Numbers are as this machine has
// them: another byte order would not go on bit for bit anyway, and is no magic.
constexpr std::uint64_t magic = 0x33307463626d6e;  // "nmbct03"; another layout, another number

struct Header {
    std::uint64_t magic_number = magic;
    std::uint64_t size = 0;
    std::uint64_t sum = 0;
};

class Writer {
  public:
    template <class Value>
    requires std::is_trivially_copyable_v<Value>
    void put(const Value& value) { append(&value, 1); }
    void put(const std::string& text) {
        put(text.size());
        append(text.data(), text.size());
    }
    void put(const Journal::Mark& mark) {
        put(mark.name);
        put(mark.size);
        put(mark.checksum);
    }
    void put(const std::pair<const std::string, std::string>& pair) {
        put(pair.first);
        put(pair.second);
    }
    void put(const std::vector<double>& values) {
        put(values.size());
        append(values.data(), values.size());
    }
    template <class List>
    void put_all(const List& values) {
        put(values.size());
        for (const auto& value : values) {
            put(value);
        }
    }
    const std::string& bytes() const { return bytes_; }

  private:
    template <class Value>
    void append(const Value* values, std::size_t count) {
        if (count > 0) {
            const std::size_t before = bytes_.size();
            bytes_.resize(before + count * sizeof(Value));
            std::memcpy(bytes_.data() + before, values, count * sizeof(Value));
        }
    }
    std::string bytes_;
};

/// Takes the values out in the same order. Throws FileError where there are too few bytes.
class Reader {
  public:
    Reader(std::string_view bytes, const std::filesystem::path& path)
        : bytes_(bytes), path_(path) {}

    template <class Value>
    requires std::is_trivially_copyable_v<Value>
    void get(Value& value) { std::memcpy(&value, take(sizeof(Value)).data(), sizeof(Value)); }
    void get(std::string& text) {
        std::size_t size = 0;
        get(size);
        text = take(size);
    }
    void get(Journal::Mark& mark) {
        get(mark.name);
        get(mark.size);
        get(mark.checksum);
    }
    void get(std::vector<double>& values) {
        std::size_t size = 0;
        get(size);
        require(size <= bytes_.size() / sizeof(double));
        values.resize(size);
        const std::string_view taken = take(size * sizeof(double));
        if (size > 0) {
            std::memcpy(values.data(), taken.data(), taken.size());
        }
    }
    template <class Value>
    void get_all(std::vector<Value>& values) {
        std::size_t size = 0;
        get(size);
        for (std::size_t i = 0; i < size; ++i) {
            get(values.emplace_back());
        }
    }
    void get_all(std::map<std::string, std::string>& pairs) {
        std::size_t size = 0;
        get(size);
        for (std::size_t i = 0; i < size; ++i) {
            std::string key;
            get(key);
            get(pairs[key]);
        }
    }

  private:
    void require(bool enough) const {
        if (!enough) {
            throw FileError(fmt::format("{} is no checkpoint of this nmbcrun", path_.string()));
        }
    }
    std::string_view take(std::size_t size) {
        require(size <= bytes_.size());
        const std::string_view taken = bytes_.substr(0, size);
        bytes_.remove_prefix(size);
        return taken;
    }
    std::string_view bytes_;
    const std::filesystem::path& path_;
};

/// Whatever archive it is: `each` takes every part of the checkpoint that is a value, `all` every
/// one that is a list.
template <class Part, class Each, class All>
void visit(Part& checkpoint, Each each, All all) {
    all(checkpoint.scene);
    each(checkpoint.steps);
    all(checkpoint.state);
    all(checkpoint.journals);
}

std::string pack(const Checkpoint& checkpoint) {
    Writer writer;
    visit(
        checkpoint, [&](const auto& value) { writer.put(value); },
        [&](const auto& list) { writer.put_all(list); });
    return writer.bytes();
}

}  // namespace

void save_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
    const std::string body = pack(checkpoint);
    const Header header{magic, body.size(), nmbcgen::checksum(body)};
    std::string head(sizeof(header), '\0');
    std::memcpy(head.data(), &header, sizeof(header));
    nmbcgen::PosixFile file = nmbcgen::PosixFile::create_beside(path);
    nmbcgen::NewFile whole(file.path(), path);
    file.write(head);
    file.write(body);
    file.sync();
    nmbcgen::publish({&whole, 1});
}

Checkpoint load_checkpoint(const std::filesystem::path& path) {
    const auto refuse = [&](const char* why) {
        return FileError(fmt::format("cannot go on from {}: {}", path.string(), why));
    };
    if (!std::filesystem::exists(path)) {
        throw refuse("there is no such file");
    }
    const nmbcgen::PosixFile file = nmbcgen::PosixFile::open(path);
    Header header;
    std::string head(sizeof(header), '\0');
    const std::size_t got = file.read(0, head.data(), head.size());
    std::memcpy(&header, head.data(), sizeof(header));
    if (got < sizeof(header) || header.magic_number != magic) {
        throw refuse("it is no checkpoint, or one of another version of nmbcrun");
    }
    if (header.size != std::filesystem::file_size(path) - sizeof(header)) {
        throw refuse("it is not whole");
    }
    std::string body(header.size, '\0');
    if (file.read(sizeof(header), body.data(), body.size()) != body.size() ||
        nmbcgen::checksum(body) != header.sum) {
        throw refuse("it is garbled");
    }
    Checkpoint checkpoint;
    Reader reader(body, path);
    visit(
        checkpoint, [&](auto& value) { reader.get(value); },
        [&](auto& list) { reader.get_all(list); });
    return checkpoint;
}

std::map<std::string, std::string> identity_of(const AnyScene& scene, bool depends_on_end,
                                               const StepPlan& plan,
                                               const std::vector<std::filesystem::path>& inputs) {
    std::map<std::string, std::string> keys = scene.given;
    if (depends_on_end) {
        keys["the number of steps"] = fmt::format("{}", plan.steps);
    } else {
        keys.erase("time.end");
    }
    keys.erase("title");
    keys.erase("output.checkpoint");
    keys["the version of nmbcrun"] = NMBC_VERSION;
    keys["the time step"] = fmt::format("{:a}", plan.time_step);
    for (const std::filesystem::path& input : inputs) {
        constexpr std::uintmax_t most_bytes = 1'000'000'000;
        std::ifstream file = open_regular_file(input, most_bytes);
        const std::string text(std::istreambuf_iterator<char>(file), {});
        keys["the checksum of " + input.string()] = fmt::format("{:x}", nmbcgen::checksum(text));
    }
    return keys;
}

void require_resumable(const std::map<std::string, std::string>& given, std::size_t last_step,
                       const Checkpoint& checkpoint, const std::filesystem::path& path) {
    const auto& stored = checkpoint.scene;
    const auto value = [](const auto& keys, const std::string& key) {
        const auto found = keys.find(key);
        return found == keys.end() ? std::string("not given") : found->second;
    };
    auto all = stored;
    all.insert(given.begin(), given.end());
    for (const auto& [key, unused] : all) {
        if (value(stored, key) != value(given, key)) {
            throw SceneError(fmt::format("{} is of another scene: there {} is {}, here {}",
                                         path.string(), key, value(stored, key),
                                         value(given, key)));
        }
    }
    if (checkpoint.steps > last_step) {
        throw SceneError(fmt::format("{} is at step {}, beyond time.end (step {})", path.string(),
                                     checkpoint.steps, last_step));
    }
}

}  // namespace nmbcrun
