#include "core/base/sha256.h"

#include <QtTest>

#include <string>
#include <vector>

using namespace berg;

/** NIST vectors: FIPS 180-2, appendix B, and the Cryptographic Algorithm Validation Program. */
class TestSha256 : public QObject
{
    Q_OBJECT

private slots:
    void publishedVectorsMatch_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("digest");
        QTest::newRow("empty")
            << QByteArray()
            << QByteArray("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
        QTest::newRow("abc")
            << QByteArray("abc")
            << QByteArray("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        QTest::newRow("two blocks")
            << QByteArray("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")
            << QByteArray("248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
        QTest::newRow("one byte (CAVP)")
            << QByteArray::fromHex("d3")
            << QByteArray("28969cdfa74a12c82f3bad960b0b000aca2ac329deea5c2328ebc6f2ba9802c1");
        QTest::newRow("a million times a")
            << QByteArray(1'000'000, 'a')
            << QByteArray("cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    }

    void publishedVectorsMatch()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, digest);
        const std::vector<std::uint8_t> bytes(text.begin(), text.end());
        const std::array<std::uint8_t, 32> found = sha256(bytes);
        QByteArray hex;
        for (std::uint8_t byte : found)
            hex += QByteArray(1, static_cast<char>(byte)).toHex();
        QCOMPARE(hex, digest);
        QCOMPARE(QByteArray::fromStdString(sha256Text(text.toStdString())), digest);
    }

    /** Compares every length near the ends of blocks with Qt. */
    void everyLengthMatchesQt()
    {
        for (int length = 0; length < 200; ++length) {
            const QByteArray text(length, 'x');
            const std::vector<std::uint8_t> bytes(text.begin(), text.end());
            const QByteArray expected = QCryptographicHash::hash(text, QCryptographicHash::Sha256);
            const std::array<std::uint8_t, 32> found = sha256(bytes);
            QVERIFY(std::equal(
                found.begin(), found.end(), expected.begin(), expected.end(),
                [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); }));
        }
    }
};

QTEST_APPLESS_MAIN(TestSha256)
#include "tst_sha256.moc"
