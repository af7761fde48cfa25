#include <QtTest>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr int kMostLines = 500;        ///< of a file
constexpr int kMostFunctionLines = 80; ///< of a function, its braces and name included
constexpr int kMostRoomFiles = 45;     ///< sources and headers of a folder
constexpr int kMostMethods = 45;       ///< declarations of functions in a class
constexpr int kMostMembers = 25;       ///< variables of a class

/** Functions and variables of a class. */
struct ClassSize
{
    std::string name;
    int methods = 0;
    int members = 0;
};

/** Classes that are larger, with their sizes: make them smaller, never larger. */
const std::vector<ClassSize> kLargeClasses{
    {"Workspace", 86, 31},         {"TimeChart", 63, 20}, {"MapView", 60, 19},
    {"AircraftController", 50, 9}, {"Autopilot", 49, 19}, {"MapScene", 46, 23},
    {"ImportDialog", 21, 28},
};

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

/** Returns the text without comments and contents of literals. */
std::string codeOf(const std::vector<std::string>& lines)
{
    std::string code;
    bool inComment = false;
    for (const std::string& line : lines) {
        if (line.starts_with('#'))
            continue;
        char quote = 0;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string_view rest = std::string_view(line).substr(i);
            if (inComment) {
                if (rest.starts_with("*/")) {
                    inComment = false;
                    ++i;
                }
            } else if (quote != 0) {
                if (line[i] == '\\')
                    ++i;
                else if (line[i] == quote)
                    quote = 0;
            } else if (rest.starts_with("//")) {
                break;
            } else if (rest.starts_with("/*")) {
                inComment = true;
                ++i;
            } else if (line[i] == '"' ||
                       (line[i] == '\'' &&
                        (i == 0 || !std::isalnum(static_cast<unsigned char>(line[i - 1]))))) {
                quote = line[i];
            } else {
                code += line[i];
            }
        }
        code += '\n';
    }
    return code;
}

bool isNameCharacter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/** Returns whether a declaration, whose braces are empty, is that of a variable `m_name`. */
bool declaresMember(const std::string& declaration)
{
    std::size_t place = declaration.rfind("m_");
    if (place == std::string::npos || (place > 0 && isNameCharacter(declaration[place - 1])))
        return false;
    while (place < declaration.size() && isNameCharacter(declaration[place]))
        ++place;
    const bool isInitialised = declaration.find(") :") != std::string::npos; // by a constructor
    return !isInitialised &&
           (place == declaration.size() ||
            std::string_view(" ={[").find(declaration[place]) != std::string::npos);
}

/** Counts one declaration at the outer level of a class. */
void countDeclaration(const std::string& text, ClassSize& size)
{
    const std::size_t start = text.find_first_not_of(" \n");
    if (start == std::string::npos)
        return;
    const std::string declaration = text.substr(start);
    for (const char* other : {"using ", "friend ", "enum ", "struct ", "class ", "static_assert"})
        if (declaration.starts_with(other))
            return;
    if (declaresMember(declaration))
        ++size.members;
    else if (declaration.find('(') != std::string::npos)
        ++size.methods;
}

/** Returns the size of the class whose body begins at `place`, behind its brace. */
ClassSize sizeOf(std::string_view code, std::size_t place, std::string name)
{
    ClassSize size{.name = std::move(name)};
    std::string declaration;
    for (int depth = 0; place < code.size(); ++place) {
        const char c = code[place];
        if (c == '{' && depth++ == 0)
            declaration += c;
        if (c == '}' && depth-- == 0)
            break;
        if (depth > 0 || c == '{')
            continue;
        const auto endsWith = [&](const char* word) { return declaration.ends_with(word); };
        if (c == '}') {
            declaration += c;
            const bool isBody = declaration.find(')') != std::string::npos;
            if (isBody && !declaresMember(declaration)) {
                countDeclaration(declaration, size);
                declaration.clear();
            }
        } else if (c == ';') {
            countDeclaration(declaration, size);
            declaration.clear();
        } else if (c == ':' && (endsWith("public") || endsWith("private") || endsWith("slots") ||
                                endsWith("protected") || endsWith("signals"))) {
            declaration.clear();
        } else {
            declaration += c;
        }
    }
    return size;
}

/** Returns the sizes of the classes at the left margin. */
std::vector<ClassSize> classesOf(const std::vector<std::string>& lines)
{
    const std::string code = '\n' + codeOf(lines);
    std::vector<ClassSize> found;
    for (std::size_t at = code.find("\nclass "); at != std::string::npos;
         at = code.find("\nclass ", at + 1)) {
        std::size_t end = at + 7;
        while (isNameCharacter(code[end]))
            ++end;
        const std::size_t open = code.find_first_of("{;", end);
        if (open != std::string::npos && code[open] == '{')
            found.push_back(sizeOf(code, open + 1, code.substr(at + 7, end - at - 7)));
    }
    return found;
}

struct Scan
{
    int files = 0;
    int functions = 0;
    int classes = 0;
    std::map<std::string, int> rooms; ///< numbers of files
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
    if (!name.starts_with("tests/"))
        for (const ClassSize& size : classesOf(text)) {
            ++scan.classes;
            const auto known = std::ranges::find(kLargeClasses, size.name, &ClassSize::name);
            const bool isKnown = known != kLargeClasses.end();
            if (size.methods > std::max(kMostMethods, isKnown ? known->methods : 0) ||
                size.members > std::max(kMostMembers, isKnown ? known->members : 0))
                scan.faults.push_back(name + ": class " + size.name + " has " +
                                      std::to_string(size.methods) + " functions and " +
                                      std::to_string(size.members) + " variables");
        }
}

Scan scanTree(const fs::path& root)
{
    Scan scan;
    for (const char* folder : {"app", "core", "tests", "widgets"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string extension = entry.path().extension().string();
            if (!entry.is_regular_file() || (extension != ".h" && extension != ".cpp"))
                continue;
            const fs::path path = fs::relative(entry.path(), root);
            scanFile(entry.path(), path.generic_string(), scan);
            if (*path.begin() != "tests")
                ++scan.rooms[path.parent_path().generic_string()];
        }
    for (const auto& [room, files] : scan.rooms)
        if (files > kMostRoomFiles)
            scan.faults.push_back(room + ": " + std::to_string(files) + " files");
    return scan;
}

} // namespace

/** Verifies that files, functions, classes and rooms keep to the limits of CONTRIBUTING.md. */
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

    void classesAreMeasured()
    {
        const std::vector<std::string> text{
            "class A;",
            "class B : public C",
            "{",
            "    Q_OBJECT",
            "public:",
            "    explicit B(int a) : m_a(a), m_b{a} {}",
            "    /** Of (it); */",
            "    [[nodiscard]] int a() const { return m_a; }",
            "    using D = int (*)(int);",
            "    void e(const F& f = {}, std::function<void()> g = {});",
            "signals:",
            "    void changed();",
            "private:",
            "    struct G",
            "    {",
            "        int h();",
            "    };",
            "    int m_a = 0;",
            "    std::function<void(int)> m_b{};",
            "    static constexpr const char* kName = \"m_(;\";",
            "};"};
        const std::vector<ClassSize> found = classesOf(text);
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found[0].name, std::string("B"));
        QCOMPARE(found[0].methods, 4);
        QCOMPARE(found[0].members, 2);
    }

    void nothingIsTooLong()
    {
        const Scan scan = scanTree(BERG_SOURCE_DIR);
        QVERIFY2(scan.files > 500 && scan.functions > 5 * scan.files, "the tree was not read");
        QVERIFY(scan.classes > 200 && scan.rooms.size() > 40);
        QString faults;
        for (const std::string& fault : scan.faults)
            faults += QString::fromStdString(fault) + '\n';
        QVERIFY2(scan.faults.empty(), qPrintable('\n' + faults));
    }
};

QTEST_APPLESS_MAIN(TestLimits)
#include "tst_limits.moc"
