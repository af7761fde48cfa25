#include "core/base/error.h"
#include "core/base/random.h"
#include "core/checks/validate.h"
#include "core/io/files/scenario_json.h"
#include "core/io/import/scenario/import_scenario.h"
#include "tests/support/files/import_fixtures.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

namespace {

/** Damages texts realistically and unrealistically. */
class Mutator
{
public:
    explicit Mutator(std::uint64_t seed) : m_random(seed, 77) {}

    std::string mutated(std::string text)
    {
        for (std::uint64_t n = 1 + m_random.below(6); n > 0 && !text.empty(); --n)
            change(text);
        return text;
    }

private:
    std::size_t place(const std::string& text) { return m_random.below(text.size()); }

    void change(std::string& text)
    {
        static const std::array<std::string, 20> kPieces = {"\"",
                                                            "\n",
                                                            "\r",
                                                            ",",
                                                            ";",
                                                            "NaN",
                                                            "1e308",
                                                            "-1e308",
                                                            "\xFF",
                                                            std::string(1, '\0'),
                                                            "90",
                                                            "-180",
                                                            "{",
                                                            "]",
                                                            "<a>",
                                                            "&x;",
                                                            "9999999999999999999",
                                                            "\xEF\xBB\xBF",
                                                            "2024-05-01T00:00:00Z",
                                                            "0"};
        const std::size_t at = place(text);
        switch (m_random.below(6)) {
        case 0:
            text[at] = static_cast<char>(m_random.below(256));
            break;
        case 1:
            text.erase(at, 1 + m_random.below(20));
            break;
        case 2:
            text.insert(at, kPieces[m_random.below(kPieces.size())]);
            break;
        case 3: { // changes a digit, so that the file stays well-formed but its numbers are wrong
            const std::size_t digit = text.find_first_of("0123456789", at);
            if (digit != std::string::npos)
                text[digit] = static_cast<char>('0' + m_random.below(10));
            break;
        }
        case 4:
            text.insert(at, text.substr(place(text), m_random.below(200)));
            break;
        case 5:
            text.resize(at);
            break;
        }
    }

    Random m_random;
};

/** Imports a text with various options. Returns false if the resulting scenario is not valid. */
bool survives(const std::string& text, const Scenario& base, const char* format)
{
    SightingTable table;
    try {
        table = readSightings(text, "mutant", {.format = format, .mapping = {}});
    } catch (const Error&) {
        return true; // rejected with a reason
    }
    const std::optional<UtcTime> times[] = {std::nullopt, table.sightings.front().time};
    for (const std::optional<UtcTime>& at : times)
        for (const bool withTracks : {false, true})
            try {
                const ImportResult result =
                    importSightings(base, table, {.at = at, .withTracks = withTracks});
                if (hasErrors(validate(result.scenario)))
                    return false;
                if (scenarioFromJson(scenarioToJson(result.scenario), "mutant") != result.scenario)
                    return false;
            } catch (const Error& error) {
                // Only existing objects of the scenario may prevent the import.
                if (base.icebergs.empty() || error.code() != ErrorCode::InvalidInput)
                    return false;
            }
    return true;
}

} // namespace

/** Any file is either rejected with an `Error` or gives a valid scenario. */
class TestImportFuzz : public QObject
{
    Q_OBJECT

private slots:
    void mutantsAreRejectedOrValid_data()
    {
        QTest::addColumn<QByteArray>("file");
        for (const ImportFixture& fixture : kImportFixtures)
            QTest::newRow(fixture.file) << QByteArray(fixture.file);
        QTest::newRow("waypoints.gpx") << QByteArray("waypoints.gpx");
    }

    void mutantsAreRejectedOrValid()
    {
        QFETCH(QByteArray, file);
        const std::string text = importFixture(file.toStdString());
        const Scenario empty = openSea();
        const Scenario full = importSightings(empty, readFixture(file.toStdString())).scenario;
        for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
            const std::string mutant = Mutator(seed).mutated(text);
            QVERIFY2(survives(mutant, seed % 2 == 0 ? empty : full, "auto"),
                     qPrintable(QString::number(seed)));
        }
    }

    /** Each file is read in every other format than its own. */
    void filesReadAsOtherFormatsAreRejectedOrValid()
    {
        for (const ImportFixture& fixture : kImportFixtures)
            for (const ImportFormat& format : importFormats()) {
                const std::string id(format.id);
                QVERIFY2(survives(importFixture(fixture.file), openSea(), id.c_str()),
                         (std::string(fixture.file) + " as " + id).c_str());
            }
    }

    void noiseIsRejectedOrValid()
    {
        Random random(1, 5);
        for (int i = 0; i < 500; ++i) {
            std::string text(random.below(400), ' ');
            for (char& c : text)
                c = static_cast<char>(1 + random.below(255));
            for (const ImportFormat& format : importFormats())
                QVERIFY(survives(text, openSea(), std::string(format.id).c_str()));
        }
    }
};

QTEST_APPLESS_MAIN(TestImportFuzz)
#include "tst_import_fuzz.moc"
