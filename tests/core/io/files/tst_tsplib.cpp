#include "core/base/stopped.h"
#include "core/io/files/tsplib.h"
#include "tests/support/expect_error.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

ProblemFile read(const std::string& text)
{
    return problemFromTsplib(text, "file");
}

std::string placesText(const std::string& type, const std::string& rows, int nodes)
{
    return "TYPE : TSP\nDIMENSION : " + std::to_string(nodes) + "\nEDGE_WEIGHT_TYPE : " + type +
           "\nNODE_COORD_SECTION\n" + rows + "EOF\n";
}

const std::string kHead = "TYPE: TSP\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: EUC_2D\n";
const std::string kExplicitHead = "TYPE: ATSP\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: EXPLICIT\n"
                                  "EDGE_WEIGHT_FORMAT: FULL_MATRIX\n";
const std::string kPlaces = "NODE_COORD_SECTION\n1 0 0\n2 3 4\n3 6 8\n";

} // namespace

class TestTsplib : public QObject
{
    Q_OBJECT

private slots:
    void problemIsAClosedTour()
    {
        const TvpProblem problem = read(kHead + kPlaces).problem;
        QVERIFY(problem.route == Route::Closed && problem.criterion == Criterion::Visitation);
        QVERIFY(problem.sigma_m2 == std::vector<double>({0, 0, 0}));
        QCOMPARE(problem.mu, 1.0);
    }

    void everyNotationIsRead_data()
    {
        QTest::addColumn<QByteArray>("text");
        const QByteArray head = QByteArray::fromStdString(kHead);
        const QByteArray places = QByteArray::fromStdString(kPlaces);
        const QByteArray usual = head + places + "EOF\n";
        QTest::newRow("usual") << usual;
        QTest::newRow("no EOF") << head + places;
        QTest::newRow("no last line end") << head + places.chopped(1);
        QTest::newRow("text behind EOF") << usual + "{ nothing of it: is read\n";
        QTest::newRow("CRLF") << QByteArray(usual).replace("\n", "\r\n");
        QTest::newRow("CR") << QByteArray(usual).replace('\n', '\r');
        QTest::newRow("byte order mark") << "\xEF\xBB\xBF" + usual;
        QTest::newRow("':' without blanks") << QByteArray(usual).replace(": ", ":");
        QTest::newRow("':' among blanks") << QByteArray(usual).replace(": ", "\t :  ");
        QTest::newRow("no ':'") << QByteArray(usual).replace(": ", " ");
        QTest::newRow("blank lines") << QByteArray(usual).replace("\n", "\n \t\n");
        QTest::newRow("indented") << "  " + QByteArray(usual).replace("\n", "\n   ");
        QTest::newRow("comments") << "# made\nCOMMENT: DIMENSION: 7\nCOMMENT: again\n" +
                                         QByteArray(usual).replace("2 3 4", "# 9 9 9\n2 3 4");
        QTest::newRow("sections first") << places + head;
        QTest::newRow("nodes in another order")
            << head + "NODE_COORD_SECTION\n3 6 8\n1 0 0\n2 3 4\n";
        QTest::newRow("words behind the type")
            << QByteArray(usual).replace("TYPE: TSP", "TYPE: TSP (of somebody)");
        QTest::newRow("no type") << QByteArray(usual).remove(0, 10);
        QTest::newRow("other entries")
            << "NAME: x\nCAPACITY: 3\nNODE_COORD_TYPE: TWOD_COORDS\nDISPLAY_DATA_TYPE: "
               "COORD_DISPLAY\nEDGE_WEIGHT_FORMAT: FUNCTION\n" +
                   usual;
        QTest::newRow("places to display")
            << QByteArray::fromStdString(kExplicitHead) +
                   "EDGE_WEIGHT_SECTION\n0 5 10 5 0 5\n10 5 0\nDISPLAY_DATA_SECTION\n1 2 3\n";
        QTest::newRow("anything on the diagonal")
            << QByteArray::fromStdString(kExplicitHead) +
                   "EDGE_WEIGHT_SECTION\n-1 5 10 5 x 5\n10 5 nan\n";
    }
    void everyNotationIsRead()
    {
        QFETCH(const QByteArray, text);
        const ProblemFile file = read(text.toStdString());
        Eigen::MatrixXd distances(3, 3);
        distances << 0, 5, 10, 5, 0, 5, 10, 5, 0;
        QVERIFY(file.problem.distance_m == distances); // the diagonal is not read
        QVERIFY(file.hints.empty());
    }

    void unknownEntryIsAHint()
    {
        const ProblemFile file = read("COLOUR: red\nSHAPE: round\n" + kHead + kPlaces);
        QCOMPARE(file.hints.size(), std::size_t{1});
        QVERIFY(file.hints.front().severity == Severity::Hint);
        QCOMPARE(file.hints.front().field, std::string("line 1"));
    }

    void formatIsRecognised()
    {
        QVERIFY(isTsplib(kHead, "/dev/stdin"));
        QVERIFY(isTsplib("\n# x\n DIMENSION:3\n", "x"));
        QVERIFY(isTsplib("{}", "x.tsp"));
        QVERIFY(isTsplib("", "x.atsp"));
        QVERIFY(!isTsplib("", "x"));
        QVERIFY(!isTsplib("{\"NAME\": 1}", "x.json"));
        QVERIFY(!isTsplib("[TYPE: TSP]", "x"));
    }

    void loaderAcceptsBothFormats()
    {
        QVERIFY(problemFromText(kHead + kPlaces, "x").isTsplib);
        QVERIFY(!problemFromText(R"({"format": "bergwatch-problem", "version": 1, "sigma": [0],
                                     "distance_m": [[0]]})",
                                 "x")
                     .isTsplib);
    }

    void faultyInstancesAreRejected_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("field");
        QTest::addColumn<int>("id");
        const auto row = [](const char* name, const std::string& text, const char* field,
                            IssueId id) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(field)
                                << static_cast<int>(id);
        };
        const std::string type = "EDGE_WEIGHT_TYPE: EUC_2D\n";
        const std::string matrix = kExplicitHead + "EDGE_WEIGHT_SECTION\n";
        row("empty", "", "DIMENSION", IssueId::Missing);
        row("no dimension", type + kPlaces, "DIMENSION", IssueId::Missing);
        row("empty dimension", "DIMENSION:\n" + type + kPlaces, "line 1, DIMENSION",
            IssueId::Missing);
        row("no nodes", "DIMENSION: 0\n" + type + kPlaces, "line 1, DIMENSION", IssueId::NotWhole);
        row("too many nodes", "DIMENSION: 1001\n" + type + kPlaces, "line 1, DIMENSION",
            IssueId::NotWhole);
        row("huge dimension", "DIMENSION: 99999999999999999999999\n" + type + kPlaces,
            "line 1, DIMENSION", IssueId::NotWhole);
        row("half a node", "DIMENSION: 3.5\n" + type + kPlaces, "line 1, DIMENSION",
            IssueId::NotWhole);
        row("negative dimension", "DIMENSION: -3\n" + type + kPlaces, "line 1, DIMENSION",
            IssueId::NotWhole);
        row("no weight type", "DIMENSION: 3\n" + kPlaces, "EDGE_WEIGHT_TYPE", IssueId::Missing);
        row("unknown weight type", "DIMENSION: 3\nEDGE_WEIGHT_TYPE: MAN_3D\n" + kPlaces,
            "line 2, EDGE_WEIGHT_TYPE", IssueId::NotOneOf);
        row("other task", "TYPE: CVRP\nDIMENSION: 3\n" + type + kPlaces, "line 1, TYPE",
            IssueId::NotOneOf);
        row("twice", kHead + "DIMENSION: 3\n" + kPlaces, "line 4, DIMENSION", IssueId::GivenTwice);
        row("section twice", kHead + kPlaces + kPlaces, "line 8, NODE_COORD_SECTION",
            IssueId::GivenTwice);
        row("fixed edges", kHead + kPlaces + "FIXED_EDGES_SECTION\n1 2\n-1\n",
            "line 8, FIXED_EDGES_SECTION", IssueId::NotOneOf);
        row("no places", kHead, "NODE_COORD_SECTION", IssueId::Missing);
        row("too few places", kHead + "NODE_COORD_SECTION\n1 0 0\n3 1 1\n",
            "line 4, NODE_COORD_SECTION", IssueId::EntryCount);
        row("too many places", kHead + kPlaces + "1 0 0\n", "line 8, 1", IssueId::GivenTwice);
        row("node twice", kHead + "NODE_COORD_SECTION\n1 0 0\n2 3 4\n2 6 8\n", "line 7, 2",
            IssueId::GivenTwice);
        row("node from 0", kHead + "NODE_COORD_SECTION\n0 0 0\n1 3 4\n2 6 8\n", "line 5",
            IssueId::NotWhole);
        row("node beyond", kHead + "NODE_COORD_SECTION\n1 0 0\n2 3 4\n4 6 8\n", "line 7",
            IssueId::NotWhole);
        row("one coordinate", kHead + "NODE_COORD_SECTION\n1 0 0\n2 3\n3 6 8\n", "line 6",
            IssueId::EntryCount);
        row("three coordinates", kHead + "NODE_COORD_SECTION\n1 0 0 0\n2 3 4\n3 6 8\n", "line 5",
            IssueId::EntryCount);
        row("a colon for a row", kHead + "NODE_COORD_SECTION\n1 0 0\n2 3 4\n:\n", "line 7",
            IssueId::EntryCount);
        row("coordinate nan", kHead + "NODE_COORD_SECTION\n1 0 0\n2 nan 4\n3 6 8\n", "line 6",
            IssueId::NotANumber);
        row("row of nan", kHead + "NODE_COORD_SECTION\n1 0 0\nnan 3 4\n3 6 8\n", "line 6",
            IssueId::NotWhole);
        row("coordinate infinite", kHead + "NODE_COORD_SECTION\n1 0 0\n2 3 -inf\n3 6 8\n", "line 6",
            IssueId::NotANumber);
        row("coordinate hexadecimal", kHead + "NODE_COORD_SECTION\n1 0 0\n2 0x3 4\n3 6 8\n",
            "line 6", IssueId::NotANumber);
        row("decimal comma", kHead + "NODE_COORD_SECTION\n1 0 0\n2 3,5 4\n3 6 8\n", "line 6",
            IssueId::NotANumber);
        row("coordinate far", kHead + "NODE_COORD_SECTION\n1 0 0\n2 3 4\n3 6e15 8\n", "line 7",
            IssueId::OutOfRange);
        row("latitude", placesText("GEO", "1 90.01 0\n2 0 0\n", 2), "line 5", IssueId::OutOfRange);
        row("longitude", placesText("GEO", "1 0 0\n2 0 -361\n", 2), "line 6", IssueId::OutOfRange);
        row("no form", "DIMENSION: 3\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_SECTION\n1 2 3\n",
            "EDGE_WEIGHT_FORMAT", IssueId::Missing);
        row("unknown form",
            "DIMENSION: 3\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: FUNCTION\n"
            "EDGE_WEIGHT_SECTION\n1 2 3\n",
            "line 3, EDGE_WEIGHT_FORMAT", IssueId::NotOneOf);
        row("no weights", kExplicitHead, "EDGE_WEIGHT_SECTION", IssueId::Missing);
        row("too few weights", matrix + "0 1 2\n1 0 3\n2 3\n", "line 5, EDGE_WEIGHT_SECTION",
            IssueId::EntryCount);
        row("too many weights", matrix + "0 1 2\n1 0 3\n2 3 0 4\n", "line 5, EDGE_WEIGHT_SECTION",
            IssueId::EntryCount);
        row("negative weight", matrix + "0 1 2\n1 0 -3\n2 3 0\n", "line 7", IssueId::OutOfRange);
        row("weight nan", matrix + "0 1 2\n1 0 NaN\n2 3 0\n", "line 7", IssueId::NotANumber);
        row("weight infinite", matrix + "0 1 2\n1 0 1e999\n2 3 0\n", "line 7", IssueId::NotANumber);
        row("weight large", matrix + "0 1 2\n1 0 1e16\n2 3 0\n", "line 7", IssueId::OutOfRange);
        row("weight a word", matrix + "0 1 2\n1 0 three\n2 3 0\n", "line 7", IssueId::NotANumber);
    }
    void faultyInstancesAreRejected()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QByteArray, field);
        QFETCH(const int, id);
        for (const QByteArray& ends : {QByteArray("\n"), QByteArray("\r\n")}) {
            const std::string given = QByteArray(text).replace("\n", ends).toStdString();
            const std::optional<Error> error = errorOf([&] { static_cast<void>(read(given)); });
            QVERIFY(error);
            QCOMPARE(codeName(error->code()), std::string("InvalidInput"));
            QCOMPARE(error->subject(), std::string("file"));
            const Issue& issue = text.isEmpty() ? error->issues().back() : error->issues().front();
            QCOMPARE(QByteArray::fromStdString(issue.field), field);
            QCOMPARE(static_cast<int>(issue.reason.id), id);
            QVERIFY2(text.isEmpty() || error->issues().size() == 1, error->what());
        }
    }

    void otherTextsAreRejected_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("code");
        QTest::newRow("words") << QByteArray("Dear all,\nDIMENSION: 3\n")
                               << QByteArray("SyntaxError");
        QTest::newRow("numbers") << QByteArray("1 2 3\n") << QByteArray("SyntaxError");
        QTest::newRow("JSON") << QByteArray("{\"a\": 1}") << QByteArray("SyntaxError");
        QTest::newRow("a colon") << QByteArray(":\n") << QByteArray("SyntaxError");
        QTest::newRow("zeros") << QByteArray("\0\0\0", 3) << QByteArray("SyntaxError");
        QTest::newRow("UTF-16") << QByteArray("\xFF\xFEN\0A\0", 6) << QByteArray("WrongFormat");
    }
    void otherTextsAreRejected()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QByteArray, code);
        QCOMPARE(codeOf([&] { static_cast<void>(read(text.toStdString())); }), code.toStdString());
    }

    void everyFaultIsNamed()
    {
        const std::optional<Error> error = errorOf([] {
            static_cast<void>(read(kExplicitHead + "EDGE_WEIGHT_SECTION\n0 -1 x\n-2 0 3\n2\n"));
        });
        QVERIFY(error);
        QCOMPARE(error->issues().size(), std::size_t{4});
        QVERIFY(names(error->issues(), "line 6") && names(error->issues(), "line 7") &&
                names(error->issues(), "line 5, EDGE_WEIGHT_SECTION"));
    }

    /** Many faults are only counted, and large files take no memory beyond the matrix. */
    void manyFaultsAreOnlyCounted()
    {
        std::string entries = kHead;
        std::string sections = kHead;
        std::string rows = kHead + "NODE_COORD_SECTION\n";
        for (int i = 0; i < 100'000; ++i) {
            entries += std::string("K") + static_cast<char>('A' + i % 26) + ": 1\n";
            sections += "X_SECTION\n";
            rows += "x y z\n";
        }
        QCOMPARE(read(entries + kPlaces).hints.size(), std::size_t{1});
        for (const std::string& text : {sections + kPlaces, rows}) {
            const std::optional<Error> error = errorOf([&] { static_cast<void>(read(text)); });
            QVERIFY(error);
            QCOMPARE(error->issues().size(), std::size_t{101});
            QVERIFY(error->issues().back().reason.id == IssueId::MoreFaults);
        }
    }

    void oneNodeGivesNoIceberg()
    {
        QCOMPARE(read(placesText("EUC_2D", "1 5 5\n", 1)).problem.icebergCount(), 0);
    }

    void stopRequestIsObeyed()
    {
        std::stop_source source;
        source.request_stop();
        QVERIFY_THROWS_EXCEPTION(Stopped, static_cast<void>(problemFromTsplib(
                                              kHead + kPlaces, "file", source.get_token())));
    }
};

QTEST_APPLESS_MAIN(TestTsplib)
#include "tst_tsplib.moc"
