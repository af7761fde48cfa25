// Our AIS decoder against the npm packages ggencoder, which encodes and decodes, and
// ais-stream-decoder. Without them the test is skipped.

#include "core/base/random.h"
#include "core/link/nmea/nmea_reader.h"
#include "tests/support/approx.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QtTest>

#include <map>

using namespace berg;

namespace {

constexpr double kKnot = 1852.0 / 3600;
constexpr double kUnit_deg = 1.0 / 600'000; ///< the encoder cuts to this

/** Runs the script of the peers with a text as its input. */
QByteArray peer(const QString& task, const QByteArray& input)
{
    QProcess node;
    node.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    node.start(QStringLiteral("node"),
               {QStringLiteral(BERG_SOURCE_DIR "/tests/app/link/ais_peer.cjs"), task});
    node.write(input);
    node.closeWriteChannel();
    return node.waitForFinished(60'000) ? node.readAllStandardOutput() : QByteArray();
}

std::vector<QJsonObject> objectsOf(const QByteArray& lines)
{
    std::vector<QJsonObject> objects;
    for (const QByteArray& line : lines.split('\n'))
        if (!line.isEmpty())
            objects.push_back(QJsonDocument::fromJson(line).object());
    return objects;
}

/** Returns 500 messages of types 1, 2, 3 and 21 as JSON lines. */
QByteArray someMessages()
{
    Random random(21);
    const auto number = [&random](int most) {
        return static_cast<double>(random.below(static_cast<std::uint64_t>(most)));
    };
    QByteArray lines;
    for (int i = 0; i < 500; ++i) {
        QJsonObject message{{QStringLiteral("repeat"), 0},
                            {QStringLiteral("mmsi"), 200'000'000 + number(500'000'000)},
                            {QStringLiteral("lat"), number(179'000) / 1000 - 89.5},
                            {QStringLiteral("lon"), number(359'000) / 1000 - 179.5}};
        if (i % 4 == 3) {
            message[QStringLiteral("aistype")] = 21;
            message[QStringLiteral("aid_type")] = 1;
            message[QStringLiteral("atonname")] = QStringLiteral("BERG %1").arg(i);
        } else {
            message[QStringLiteral("aistype")] = 1 + i % 4;
            message[QStringLiteral("navstatus")] = 0;
            message[QStringLiteral("rot")] = 0;
            message[QStringLiteral("smi")] = 0;
            message[QStringLiteral("sog")] = number(300) / 10 + 0.05;
            message[QStringLiteral("cog")] = number(3600) / 10 + 0.05;
            message[QStringLiteral("hdg")] = number(360);
        }
        lines += QJsonDocument(message).toJson(QJsonDocument::Compact) + '\n';
    }
    return lines;
}

std::vector<NmeaTarget> targetsOf(const QByteArray& text)
{
    NmeaReader reader;
    const std::string lines = text.toStdString();
    (void)reader.feed({reinterpret_cast<const std::uint8_t*>(lines.data()), lines.size()});
    return reader.takeTargets();
}

} // namespace

class TestAisPeer : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!qEnvironmentVariableIsSet("BERGWATCH_NODE_MODULES"))
            qputenv("BERGWATCH_NODE_MODULES", BERG_SOURCE_DIR "/build/node/node_modules");
        const QString check = QStringLiteral("for (const name of ['ggencoder', "
                                             "'ais-stream-decoder']) "
                                             "require(process.env.BERGWATCH_NODE_MODULES + '/' + "
                                             "name)");
        if (QProcess::execute(QStringLiteral("node"), {QStringLiteral("-e"), check}) != 0)
            QSKIP("node or its packages ggencoder and ais-stream-decoder are missing: AIS was not "
                  "tested with an independent encoder and decoder");
    }

    /** Messages of ggencoder are read as they were encoded. */
    void encodedMessagesAreRead()
    {
        const std::vector<QJsonObject> sent = objectsOf(someMessages());
        const std::vector<NmeaTarget> read =
            targetsOf(peer(QStringLiteral("encode"), someMessages()));
        QCOMPARE(read.size(), sent.size());
        for (std::size_t i = 0; i < sent.size(); ++i) {
            const auto number = [&](const char* name) {
                return sent[i][QLatin1String(name)].toDouble();
            };
            QCOMPARE(static_cast<double>(read[i].id), number("mmsi"));
            COMPARE_NEAR(read[i].place.latitude_deg, number("lat"), kUnit_deg);
            COMPARE_NEAR(read[i].place.longitude_deg, number("lon"), kUnit_deg);
            if (read[i].kind == NmeaTarget::Kind::Aid) {
                QCOMPARE(QString::fromStdString(read[i].name),
                         sent[i][QStringLiteral("atonname")].toString());
                continue;
            }
            COMPARE_NEAR(*read[i].speed_mps, (number("sog") - 0.05) * kKnot, 1e-9);
            COMPARE_NEAR(*read[i].course_deg, number("cog") - 0.05, 1e-9);
        }
    }

    /** Both decoders read in the same sentences what we read. */
    void decodersAgree()
    {
        const QByteArray sentences = peer(QStringLiteral("encode"), someMessages()) +
                                     "!AIVDM,1,1,,B,15M67FC000G?ufbE`FepT@3n00Sa,0*5C\n"
                                     "!AIVDM,1,1,,B,133i;RPP1DPEbcDMV@1r:Ow:2>`<,0*41\n";
        std::map<std::uint32_t, NmeaTarget> ours;
        for (const NmeaTarget& target : targetsOf(sentences))
            ours[target.id] = target;
        int compared = 0;
        for (const QJsonObject& theirs : objectsOf(peer(QStringLiteral("decode"), sentences))) {
            const auto number = [&](const char* name) {
                return theirs[QLatin1String(name)].toDouble();
            };
            const auto found = ours.find(static_cast<std::uint32_t>(number("mmsi")));
            QVERIFY(found != ours.end());
            COMPARE_NEAR(found->second.place.latitude_deg, number("lat"), 1e-6);
            COMPARE_NEAR(found->second.place.longitude_deg, number("lon"), 1e-6);
            if (found->second.kind == NmeaTarget::Kind::Ship) {
                COMPARE_NEAR(*found->second.speed_mps, number("sog") * kKnot, 1e-6);
                COMPARE_NEAR(*found->second.course_deg, number("cog"), 1e-6);
            }
            ++compared;
        }
        QVERIFY2(compared >= 377 + 502, qPrintable(QString::number(compared)));
    }
};

QTEST_GUILESS_MAIN(TestAisPeer)
#include "tst_ais_peer.moc"
