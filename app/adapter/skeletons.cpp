#include "app/adapter/skeletons.h"

#include <fmt/format.h>

#include "app/adapter/adapter_parts.h"
#include "model/input_error.h"

namespace touchstone::app {
namespace {

/// {0} is the adapter's name, which is also that of its folder.
struct Language {
  const char* name;
  const AdapterParts& parts;
  const char* ending;          ///< of the adapter's file
  const char* library_ending;  ///< of the library's
  const char* build;           ///< empty if nothing is built
  const char* run;
};

const std::vector<Language>& languages() {
  static const std::vector<Language> all = {
      {"js", js_parts, "mjs", "mjs", "", "node {0}/{0}.mjs"},
      {"python", python_parts, "py", "py", "", "python3 {0}/{0}.py"},
      {"rust", rust_parts, "rs", "rs", "cargo build --release --manifest-path {0}/Cargo.toml",
       "{0}/target/release/{0}"},
      {"cpp", cpp_parts, "cpp", "h", "g++ -std=c++17 -O2 {0}/{0}.cpp -o {0}/{0}", "{0}/{0}"},
  };
  return all;
}

constexpr const char* cargo = R"([package]
name = "{0}"
version = "0.1.0"
edition = "2021"

[[bin]]
name = "{0}"
path = "{0}.rs"
)";

std::string named(std::string text, const std::string& name) {
  for (std::size_t at = text.find("NAME"); at != std::string::npos; at = text.find("NAME", at + name.size())) {
    text.replace(at, 4, name);
  }
  return text;
}

std::string with_name(const char* pattern, const std::string& name) { return fmt::format(fmt::runtime(pattern), name); }

}  // namespace

const std::vector<std::string>& adapter_languages() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Language& language : languages()) all.emplace_back(language.name);
    return all;
  }();
  return names;
}

Skeleton skeleton_of(const std::string& language, const std::string& name) {
  for (const Language& known : languages()) {
    if (known.name != language) continue;
    Skeleton skeleton;
    skeleton.files = {
        {name + '.' + known.ending, named(known.parts.skeleton, name), "the adapter: fill in what is marked TODO"},
        {std::string("touchstone_adapter.") + known.library_ending, known.parts.library,
         "speaks the protocol; stays as it is"}};
    if (language == "rust") skeleton.files.push_back({"Cargo.toml", with_name(cargo, name), "builds it"});
    if (*known.build != '\0') skeleton.next.push_back(with_name(known.build, name));
    skeleton.next.push_back(fmt::format("touchstone adapter check \"exec:{}\"", with_name(known.run, name)));
    return skeleton;
  }
  throw InputError("--lang \"" + language + '"', "unknown");
}

}  // namespace touchstone::app
