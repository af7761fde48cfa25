#include "tests/support/files/known_check.h"
#include "tests/support/files/known_files.h"

#include <QtTest>

#include <fstream>
#include <map>

using namespace berg;
using namespace berg::test;

namespace {

std::size_t fileCount()
{
    return static_cast<std::size_t>(qEnvironmentVariableIntValue("BERGWATCH_IMPORT_FILES"));
}

/** Stores a failed file for inspection in the folder that the environment variable names. */
void keep(const KnownFile& file)
{
    const QByteArray folder = qgetenv("BERGWATCH_IMPORT_FOLDER");
    if (!folder.isEmpty())
        std::ofstream(folder.toStdString() + '/' + file.name, std::ios::binary) << file.bytes;
}

std::string lineOf(const KnownFile& file, const ImportFinding& finding)
{
    std::string text = file.name + " [";
    for (const std::string& trait : file.traits)
        text += trait + ", ";
    return text + "] " + finding.why + '\n';
}

} // namespace

/** Generated files with known content: nothing is read wrongly or lost without a note. */
class TestImportKnown : public QObject
{
    Q_OBJECT

private slots:
    /** Tests the number of files in BERGWATCH_IMPORT_FILES, or 1000. */
    void nothingIsSilentlyWrongOrLost()
    {
        const std::size_t files = fileCount() > 0 ? fileCount() : 1000;
        std::map<ImportVerdict, std::size_t> counts;
        std::string faults;
        std::string refusals;
        for (std::size_t number = 0; number < files; ++number) {
            const KnownFile file = knownFile(number);
            const ImportFinding finding = findingOf(file);
            ++counts[finding.verdict];
            if (finding.verdict == ImportVerdict::Wrong || finding.verdict == ImportVerdict::Lost) {
                faults += lineOf(file, finding);
                keep(file);
            } else if (finding.verdict != ImportVerdict::Right) {
                refusals += lineOf(file, finding);
            }
        }
        const auto all = static_cast<double>(files);
        qInfo("%zu files: %zu right, %zu with rows left out, %zu refused, %zu lost, %zu wrong",
              files, counts[ImportVerdict::Right], counts[ImportVerdict::Listed],
              counts[ImportVerdict::Refused], counts[ImportVerdict::Lost],
              counts[ImportVerdict::Wrong]);
        if (fileCount() > 0)
            qInfo("%s", refusals.c_str());
        QVERIFY2(faults.empty(), faults.c_str());
        QVERIFY(static_cast<double>(counts[ImportVerdict::Right]) > 0.5 * all);
    }

    /** Different numbers give different files; the same number gives the same file. */
    void filesAreReproducible()
    {
        std::set<std::string> all;
        for (std::uint64_t number = 0; number < 100; ++number) {
            QVERIFY(knownFile(number).bytes == knownFile(number).bytes);
            all.insert(knownFile(number).bytes);
        }
        QCOMPARE(all.size(), std::size_t{100});
    }

    /** The check itself detects faults. */
    void checkSeesFaults()
    {
        std::size_t seen = 0;
        for (std::uint64_t number = 0; number < 60; ++number) {
            KnownFile file = knownFile(number);
            if (findingOf(file).verdict != ImportVerdict::Right || !file.hasIds ||
                file.isAmbiguous) // a reported ambiguity excuses its consequences
                continue;
            KnownFile moved = file;
            const auto good = std::ranges::find(moved.places, true, &test::KnownPlace::isGood);
            good->latitude_deg += 0.2; // more than the coarsest notation of a place rounds
            QVERIFY(findingOf(moved).verdict >= ImportVerdict::Lost);
            KnownFile renamed = file;
            renamed.bergs.front().id += "x";
            QVERIFY(findingOf(renamed).verdict == ImportVerdict::Wrong);
            KnownFile more = file;
            more.places.push_back(more.places.front());
            more.places.back().latitude_deg += 0.2;
            QVERIFY(findingOf(more).verdict >= ImportVerdict::Lost);
            ++seen;
        }
        QVERIFY(seen > 5);
    }
};

QTEST_APPLESS_MAIN(TestImportKnown)
#include "tst_import_known.moc"
