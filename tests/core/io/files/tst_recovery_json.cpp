#include "core/base/error.h"
#include "core/io/files/recovery_json.h"

#include <QtTest>

using namespace berg;

class TestRecoveryJson : public QObject
{
    Q_OBJECT

private slots:
    void everyFieldIsReadBack()
    {
        const RecoveryNote note{.originalPath = "/home/\"\u00c5se\"\n/watch.berg",
                                .editedUtc = "2021-05-02T03:04:05.678Z",
                                .pid = 4194304,
                                .host = "bridge"};
        QVERIFY(recoveryFromJson(recoveryToJson(note), "note") == note);
        QVERIFY(recoveryFromJson("{}", "note") == RecoveryNote{});
    }

    /** A note written by a version that also stored the name. */
    void earlierNotesAreRead()
    {
        const RecoveryNote note = recoveryFromJson(
            R"({"edited_utc": "2021-05-02T03:04:05.678Z", "host": "bridge", "name": "Watch",
                "original_path": "/srv/watch.berg", "pid": 7})",
            "note");
        QCOMPARE(note.originalPath, std::string("/srv/watch.berg"));
        QCOMPARE(note.editedUtc, std::string("2021-05-02T03:04:05.678Z"));
        QCOMPARE(note.pid, std::int64_t{7});
        QCOMPARE(note.host, std::string("bridge"));
    }

    void damagedNotesAreRejected()
    {
        QVERIFY_THROWS_EXCEPTION(Error, (void)recoveryFromJson("{\"pid\": 7", "note"));
        QVERIFY_THROWS_EXCEPTION(Error, (void)recoveryFromJson("[]", "note"));
        QVERIFY_THROWS_EXCEPTION(Error, (void)recoveryFromJson("{\"pid\": \"7\"}", "note"));
    }
};

QTEST_APPLESS_MAIN(TestRecoveryJson)
#include "tst_recovery_json.moc"
