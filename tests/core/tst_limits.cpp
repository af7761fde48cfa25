#include <QtTest>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr int kMostLines = 500;        ///< of a file
constexpr int kMostFunctionLines = 80; ///< of a function, its braces and name included

/** A function in a file, from the line of its name to its closing brace. */
struct Function
{
    std::string name; ///< its first line
    int line = 0;
    int lines = 0;
};

/**
 * Returns whether a function is a table of test data, which grows by rows only and has no limit.
 */
bool isTable(std::string_view name)
{
    return name.ends_with("_data()") || name.ends_with(" cases()");
}

/** Returns the part of a line after the indent, or an empty text for a line with less indent. */
std::string withoutIndent(std::string_view line, std::size_t indent)
{
    return line.find_first_not_of(' ') < indent
               ? std::string()
               : std::string(line.substr(std::min(indent, line.size())));
}

/**
 * Returns the functions of `text`, as the formatter lays them out: a brace alone on a line opens
 * one, at the left margin or one step inside a class, and a brace at the same margin closes it.
 * Braces of types look the same, but end in "};", or have a type's keyword before them.
 */
std::vector<Function> functionsOf(const std::vector<std::string>& text)
{
    std::vector<Function> found;
    for (std::size_t indent : {std::size_t{0}, std::size_t{4}}) {
        std::size_t first = 0; // Line of the name.
        std::size_t open = 0;  // Line after the brace; 0 outside a function.
        for (std::size_t i = 0; i < text.size(); ++i) {
            const std::string line = withoutIndent(text[i], indent);
            if (open == 0 && line == "{") {
                open = i + 1;
            } else if (open == 0 && !line.empty() && line.front() != ' ' &&
                       (i == 0 || text[i - 1].empty() || text[i - 1].ends_with('}') ||
                        text[i - 1].ends_with(':') || text[i - 1].ends_with(';') ||
                        text[i - 1].ends_with("*/"))) {
                first = i;
            } else if (open > 0 && line.starts_with('}')) {
                if (line == "}")
                    found.push_back({withoutIndent(text[first], indent),
                                     static_cast<int>(first) + 1, static_cast<int>(i - first) + 1});
                open = 0;
            }
        }
    }
    return found;
}

/** Returns the lines of a file. Lines of raw texts are empty because they may hold braces. */
std::vector<std::string> linesOf(const fs::path& path)
{
    std::ifstream in(path);
    std::vector<std::string> lines;
    bool raw = false;
    for (std::string line; std::getline(in, line);) {
        const bool ends = line.find(")\"") != std::string::npos;
        const bool begins = line.find("R\"(") != std::string::npos;
        lines.push_back(raw ? std::string() : line);
        raw = (raw || begins) && !ends;
    }
    return lines;
}

struct Scan
{
    int files = 0;
    int functions = 0;
    std::vector<std::string> faults;
};

void scanFile(const fs::path& path, const std::string& name, Scan& scan)
{
    const std::vector<std::string> text = linesOf(path);
    ++scan.files;
    if (static_cast<int>(text.size()) > kMostLines)
        scan.faults.push_back(name + ": " + std::to_string(text.size()) + " lines");
    for (const Function& function : functionsOf(text)) {
        ++scan.functions;
        if (function.lines > kMostFunctionLines && !isTable(function.name))
            scan.faults.push_back(name + ':' + std::to_string(function.line) + ": " +
                                  std::to_string(function.lines) + " lines: " + function.name);
    }
}

Scan scanTree(const fs::path& root)
{
    Scan scan;
    for (const char* folder : {"app", "core", "tests", "widgets"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string extension = entry.path().extension().string();
            if (entry.is_regular_file() && (extension == ".h" || extension == ".cpp"))
                scanFile(entry.path(), fs::relative(entry.path(), root).generic_string(), scan);
        }
    return scan;
}

} // namespace

/** Verifies that files and functions keep to the lengths that CONTRIBUTING.md names. */
class TestLimits : public QObject
{
    Q_OBJECT

private slots:
    /**
     * Verifies which functions are counted, because a check that finds no function would always
     * pass.
     */
    void functionsAreFound()
    {
        const std::vector<std::string> text{"namespace a {",
                                            "",
                                            "struct B",
                                            "{",
                                            "    int c = 0;",
                                            "    void d()",
                                            "    {",
                                            "        c = 1;",
                                            "    }",
                                            "};",
                                            "",
                                            "/** What. */",
                                            "int longName(int a,",
                                            "             int b)",
                                            "{",
                                            "    if (a)",
                                            "        return b;",
                                            "    return a;",
                                            "}",
                                            "}"};
        const std::vector<Function> found = functionsOf(text);
        QCOMPARE(found.size(), std::size_t{2});
        QCOMPARE(found[0].name, std::string("int longName(int a,"));
        QCOMPARE(found[0].line, 13);
        QCOMPARE(found[0].lines, 7);
        QCOMPARE(found[1].name, std::string("void d()"));
        QCOMPARE(found[1].lines, 4);
    }

    void nothingIsTooLong()
    {
        const Scan scan = scanTree(BERG_SOURCE_DIR);
        QVERIFY2(scan.files > 500 && scan.functions > 5 * scan.files, "the tree was not read");
        QString faults;
        for (const std::string& fault : scan.faults)
            faults += QString::fromStdString(fault) + '\n';
        QVERIFY2(scan.faults.empty(), qPrintable('\n' + faults));
    }
};

QTEST_APPLESS_MAIN(TestLimits)
#include "tst_limits.moc"
