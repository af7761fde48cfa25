#include "core/io/text/json_writer.h"

#include <QTest>

#include <nlohmann/json.hpp>

#include <limits>

using namespace berg;
using Tree = nlohmann::ordered_json;

/** Objects built from texts are tested with the files that contain them. */
class TestJsonWriter : public QObject
{
    Q_OBJECT

private slots:
    void treesAreWrittenOnOneLine()
    {
        const Tree tree{{"a", {1, -2, 3.5, 22.0, -0.0, 1e300, 2e-5}}, {"b", Tree::object()}};
        QCOMPARE(jsonText(tree),
                 std::string(R"({"a":[1,-2,3.5,22.0,-0.0,1e+300,0.00002],"b":{}})"));
        QCOMPARE(jsonText(Tree(18446744073709551615U)), std::string("18446744073709551615"));
        QCOMPARE(jsonText(Tree{nullptr, true, false}), std::string("[null,true,false]"));
        QCOMPARE(jsonText(Tree(std::numeric_limits<double>::quiet_NaN())), std::string("null"));
    }

    void treesAreWrittenWithALineForEachEntry()
    {
        const Tree tree{{"a", {1, 2}}, {"b", Tree::array()}, {"c", {{"d", "e"}}}};
        for (const int indent : {0, 1, 4})
            QCOMPARE(jsonText(tree, indent), tree.dump(indent));
    }

    /** Terminal control characters and invalid UTF-8 are not written. */
    void controlCharactersAreEscaped()
    {
        const std::string hostile = "\x1b[31m \x7f \xC2\x9B \xFF \" \\ \n \xC3\xA6";
        const std::string safe =
            "\"\\u001b[31m \\u007f \\u009b \xEF\xBF\xBD \\\" \\\\ \\n \xC3\xA6\"";
        QCOMPARE(jsonText(hostile), safe);
        QCOMPARE(jsonText(Tree(hostile)), safe);
        QCOMPARE(jsonText(Tree{{hostile, 1}}), '{' + safe + ":1}");
    }
};

QTEST_APPLESS_MAIN(TestJsonWriter)
#include "tst_json_writer.moc"
