#include "core/io/atomic_file.h"
#include "core/io/file_set.h"
#include "tests/support/expect_error.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace berg;
using berg::test::errorOf;
using namespace Qt::StringLiterals;

/** Several files that belong together. */
class TestFileSet : public QObject
{
    Q_OBJECT

private slots:
    void allAreWritten()
    {
        const QTemporaryDir folder;
        const std::string first = folder.filePath(u"a.plan"_s).toStdString();
        const std::string second = folder.filePath(u"b.plan"_s).toStdString();
        writeFileAtomically(second, "old");
        writeFileSet(std::vector<NewFile>{{first, "1"}, {second, "2"}});
        QCOMPARE(readFile(first), std::string("1"));
        QCOMPARE(readFile(second), std::string("2"));
        writeFileSet(std::vector<NewFile>{{first, "3"}});
        QCOMPARE(readFile(first), std::string("3"));
    }

    /** The last one cannot be: what was there before is there again, what was not is not. */
    void noneIsWrittenWhenOneCannotBe()
    {
        const QTemporaryDir folder;
        const std::string there = folder.filePath(u"a.plan"_s).toStdString();
        const std::string fresh = folder.filePath(u"b.plan"_s).toStdString();
        const std::string last = folder.filePath(u"c.plan"_s).toStdString();
        QVERIFY(QDir(folder.path()).mkdir(u"c.plan"_s));
        writeFileAtomically(there, "old");
        const std::vector<NewFile> files{{there, "1"}, {fresh, "2"}, {last, "3"}};
        const std::optional<Error> error = errorOf([&] { writeFileSet(files); });
        QVERIFY(error && error->code() == ErrorCode::FileUnwritable && error->subject() == last);
        QCOMPARE(readFile(there), std::string("old"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{u"a.plan"_s});
    }
};

QTEST_APPLESS_MAIN(TestFileSet)
#include "tst_file_set.moc"
