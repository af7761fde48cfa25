// A program of many tests: the first argument selects the test, the rest is passed to QtTest.
#include "tests/support/test_list.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

namespace {

using Run = int (*)(int argc, char** argv);

std::map<std::string, Run>& tests()
{
    static std::map<std::string, Run> byName;
    return byName;
}

} // namespace

bool berg::enlistTest(const char* file, int (*run)(int argc, char** argv))
{
    return tests().emplace(std::filesystem::path(file).stem().string(), run).second;
}

int main(int argc, char** argv)
{
    const auto test = tests().find(argc > 1 ? argv[1] : "");
    if (test == tests().end()) {
        std::fprintf(stderr, "name one of these tests first:\n");
        for (const auto& [name, run] : tests())
            std::fprintf(stderr, "  %s\n", name.c_str());
        return 2;
    }
    argv[1] = argv[0];
    return test->second(argc - 1, argv + 1);
}
