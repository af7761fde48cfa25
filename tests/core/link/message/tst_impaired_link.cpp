#include "core/link/message/impaired_link.h"
#include "core/link/message/memory_link.h"

#include <QtTest>

using namespace berg;

namespace {

int received(ByteLink& link)
{
    int count = 0;
    while (link.receive())
        ++count;
    return count;
}

const std::vector<std::uint8_t> kBytes{1, 2, 3};

} // namespace

class TestImpairedLink : public QObject
{
    Q_OBJECT

private slots:
    void packetsOfBothDirectionsAreDelayed()
    {
        auto [near, far] = MemoryLink::pair();
        ImpairedLink link(near, {.delay_s = 1.5});
        link.send(0, kBytes);
        far.send(0, kBytes);
        link.setTime(0); // reads received packets
        link.setTime(1.4);
        QCOMPARE(received(far) + received(link), 0);
        link.setTime(1.6);
        QCOMPARE(received(far), 1);
        const std::optional<LinkPacket> packet = link.receive();
        QVERIFY(packet && packet->bytes == kBytes);
        QVERIFY(!link.receive());
    }

    /** 2000 packets at 20 %: 400 are lost, within five standard deviations (5 x 18). */
    void shareOfPacketsIsLost()
    {
        auto [near, far] = MemoryLink::pair();
        ImpairedLink link(near, {.loss = 0.2, .seed = 3});
        for (int i = 0; i < 2000; ++i)
            link.send(0, kBytes);
        link.setTime(0);
        const int arrived = received(far);
        QVERIFY2(std::abs(arrived - 1600) < 90, std::to_string(arrived).c_str());
        link.setImpairment({.loss = 1});
        link.send(0, kBytes);
        far.send(0, kBytes);
        link.setTime(10);
        QCOMPARE(received(far) + received(link), 0);
    }

    void otherPeersGetNothing()
    {
        auto [near, far] = MemoryLink::pair();
        near.send(1, kBytes);
        QCOMPARE(received(far), 0);
        QVERIFY(near.peers() == std::vector<int>{0});
    }
};

QTEST_APPLESS_MAIN(TestImpairedLink)
#include "tst_impaired_link.moc"
