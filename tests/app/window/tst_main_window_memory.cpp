#include "core/io/files/scenario_json.h"
#include "tests/support/window/import_dialog_test.h"
#include "tests/support/window/window_fixture.h"

#include <QFile>

#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** While it lives, this program gets so much more memory than it has, and no more. */
class MemoryLimit
{
public:
    explicit MemoryLimit(rlim_t more_bytes)
    {
        ::getrlimit(RLIMIT_AS, &m_before);
        rlim_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const rlimit limit{pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + more_bytes,
                           m_before.rlim_max};
        if (pages == 0 || ::setrlimit(RLIMIT_AS, &limit) != 0)
            qFatal("no limit");
    }
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;
    ~MemoryLimit() { ::setrlimit(RLIMIT_AS, &m_before); }

private:
    rlimit m_before{};
};

} // namespace

/** Memory runs out during work: the window shows a message and continues. */
class TestMainWindowMemory : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void importOfALargeFile()
    {
        WindowFixture w(test::openSea());
        QByteArray table("id,latitude,longitude,time\n");
        for (int i = 0; i < 1'000'000; ++i)
            table += "berg-" + QByteArray::number(i) + ",47.1234,-48.5678,2021-04-01T00:00:00Z\n";
        QFile file(w.file(u"large.csv"_s));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(table) == table.size());
        file.close();
        table = {};

        ImportRunner& imports = w.workspace.imports();
        std::shared_ptr<const ImportPreview> preview;
        QObject context;
        QObject::connect(&imports, &ImportRunner::ready, &context,
                         [&](const std::shared_ptr<const ImportPreview>& made) { preview = made; });
        // The window does nothing else meanwhile: what it asks for itself is not the import's to
        // take.
        QVERIFY(w.untilReady());
        QVERIFY(w.until([&] { return w.record().boundOfFlight().share >= 1; }));
        {
            constexpr rlim_t kMore_bytes = 150U << 20U; // the file, and half of its rows
            const MemoryLimit limit(kMore_bytes);
            imports.start({.path = file.fileName(),
                           .base = std::make_shared<const Scenario>(test::openSea())},
                          true);
            QVERIFY(w.until([&] { return preview != nullptr; }));
            QVERIFY(preview->error.has_value());
            QCOMPARE(preview->error->subject(), std::string("memory"));
            QVERIFY(!preview->isUsable());
            // The rest of the window has what it needs.
            w.dragTau(0.2, 0.7);
            w.interaction.path = w.file(u"kept.berg"_s);
            w.trigger(u"saveAction"_s);
            QVERIFY(w.untilReady());
        }
        QVERIFY(w.interaction.errors.isEmpty());
        QVERIFY(loadScenario(w.interaction.path.toStdString()) == w.scenario());
        QVERIFY(!w.window().grab().isNull());

        imports.start({.path = test::fixturePath("iip.csv"),
                       .base = std::make_shared<const Scenario>(test::openSea())},
                      true);
        QVERIFY(w.until([&] { return preview->isUsable(); }));
    }
};

QTEST_MAIN(TestMainWindowMemory)
#include "tst_main_window_memory.moc"
