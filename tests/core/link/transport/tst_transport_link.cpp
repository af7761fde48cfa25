#include "core/base/descriptor.h"
#include "core/link/transport/transport_link.h"

#include <QtTest>

#include <arpa/inet.h>
#include <pty.h>
#include <sys/socket.h>

using namespace berg;

namespace {

using Kind = LinkEndpoint::Kind;
using State = LinkCondition::State;

constexpr int kFirstPort = 20'000;
const std::vector<std::uint8_t> kPing{1, 2, 3};
const std::vector<std::uint8_t> kPong{4, 5};

/** Calls `receive` until there is a packet, or five seconds have passed. */
std::optional<LinkPacket> awaited(ByteLink& link)
{
    std::optional<LinkPacket> packet;
    (void)QTest::qWaitFor([&] { return (packet = link.receive()).has_value(); });
    return packet;
}

bool isOpened(TransportLink& link)
{
    return QTest::qWaitFor([&] {
        (void)link.receive();
        return link.condition().state == State::Open;
    });
}

/** Opens a listening link at the first port that is free. */
std::pair<std::unique_ptr<TransportLink>, int> listeningLink()
{
    for (int port = kFirstPort;; ++port) {
        std::unique_ptr<TransportLink> link = openLink({.port = port});
        (void)link->receive();
        if (link->condition().state == State::Open)
            return {std::move(link), port};
    }
}

/** A server on a port of the system's choice. */
struct Server
{
    Descriptor socket{::socket(AF_INET, SOCK_STREAM, 0)};
    int port = 0;

    Server()
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        auto* const generic = reinterpret_cast<sockaddr*>(&address);
        if (::bind(socket.get(), generic, size) == 0 && ::listen(socket.get(), 1) == 0 &&
            ::getsockname(socket.get(), generic, &size) == 0)
            port = ntohs(address.sin_port);
    }
};

/** Reads what the link still sends, until nothing more comes. */
std::size_t arriving_bytes(TransportLink& link, int client)
{
    std::vector<char> piece(std::size_t{1} << 20U);
    std::size_t sum_bytes = 0;
    while (true) {
        ssize_t got = 0;
        const bool isMore = QTest::qWaitFor(
            [&] {
                (void)link.receive(); // sends what is waiting
                got = ::recv(client, piece.data(), piece.size(), MSG_DONTWAIT);
                return got > 0;
            },
            500);
        if (!isMore)
            return sum_bytes;
        sum_bytes += static_cast<std::size_t>(got);
    }
}

} // namespace

class TestTransportLink : public QObject
{
    Q_OBJECT

private slots:
    void datagramsAreAnsweredToTheirSender()
    {
        const auto [station, port] = listeningLink();
        QVERIFY(station->isDatagram() && station->peers().empty());
        const std::unique_ptr<TransportLink> vehicle =
            openLink({.kind = Kind::UdpSend, .port = port});
        vehicle->send(0, kPing); // not open yet
        QVERIFY(isOpened(*vehicle));
        QVERIFY(vehicle->peers() == std::vector<int>{0});
        vehicle->send(0, kPing);
        const std::optional<LinkPacket> ping = awaited(*station);
        QVERIFY(ping && ping->peer == 0 && ping->bytes == kPing);
        QVERIFY(station->peers() == std::vector<int>{0});
        QVERIFY(station->peerName(0).starts_with("127.0.0.1:"));
        QCOMPARE(station->peerName(1), std::string());
        station->send(0, kPong);
        station->send(1, kPing); // nobody
        const std::optional<LinkPacket> pong = awaited(*vehicle);
        QVERIFY(pong && pong->bytes == kPong);
        QVERIFY(!vehicle->receive());
    }

    void strangersAreIgnored()
    {
        const auto [station, port] = listeningLink();
        const std::unique_ptr<TransportLink> vehicle =
            openLink({.kind = Kind::UdpSend, .port = port});
        QVERIFY(isOpened(*vehicle));
        vehicle->send(0, kPing);
        QVERIFY(awaited(*station));
        const int own = std::stoi(station->peerName(0).substr(10));
        const std::unique_ptr<TransportLink> stranger =
            openLink({.kind = Kind::UdpSend, .port = own});
        QVERIFY(isOpened(*stranger));
        stranger->send(0, kPing);
        QVERIFY(QTest::qWaitFor(
            [&, &link = vehicle] { return !link->receive() && link->ignored() == 1; }));
        QVERIFY(vehicle->lastIgnored().starts_with("127.0.0.1:"));
    }

    /** The peers cannot be driven out by many new ones, nor by datagrams of any length. */
    void peersAndDatagramsAreLimited()
    {
        const auto [station, port] = listeningLink();
        std::vector<std::unique_ptr<TransportLink>> vehicles;
        for (int i = 0; i < 33; ++i) {
            vehicles.push_back(openLink({.kind = Kind::UdpSend, .port = port}));
            QVERIFY(isOpened(*vehicles.back()));
            vehicles.back()->send(0, kPing);
            if (i < 32) {
                const std::optional<LinkPacket> packet = awaited(*station);
                QVERIFY(packet && packet->peer == i);
            }
        }
        QVERIFY(QTest::qWaitFor(
            [&, &link = station] { return !link->receive() && link->ignored() == 1; }));
        const std::string stranger = station->lastIgnored();
        vehicles.front()->send(0, std::vector<std::uint8_t>(2049));
        vehicles.front()->send(0, std::vector<std::uint8_t>(2048));
        const std::optional<LinkPacket> packet = awaited(*station);
        QVERIFY(packet && packet->bytes.size() == 2048);
        QCOMPARE(station->ignored(), std::uint64_t{1}); // the other one is no stranger
        QCOMPARE(station->lastIgnored(), stranger);
    }

    /** A datagram that is dropped for its length does not make its sender a peer. */
    void longDatagramsMakeNoPeer()
    {
        const auto [station, port] = listeningLink();
        const std::unique_ptr<TransportLink> sender =
            openLink({.kind = Kind::UdpSend, .port = port});
        const std::unique_ptr<TransportLink> vehicle =
            openLink({.kind = Kind::UdpSend, .port = port});
        QVERIFY(isOpened(*sender) && isOpened(*vehicle));
        sender->send(0, std::vector<std::uint8_t>(2049));
        vehicle->send(0, kPing);
        const std::optional<LinkPacket> packet = awaited(*station);
        QVERIFY(packet && packet->peer == 0);
        QVERIFY(station->peers() == std::vector<int>{0});
    }

    void usedPortIsAFaultUntilItIsFree()
    {
        auto [first, port] = listeningLink();
        const std::unique_ptr<TransportLink> second = openLink({.port = port});
        QVERIFY(!second->receive());
        QCOMPARE(second->condition().state, State::Broken);
        QVERIFY(!second->condition().fault.empty());
        first.reset();
        QVERIFY(isOpened(*second));
        QCOMPARE(second->condition().fault, std::string());
    }

    void streamIsExchangedWithAServer()
    {
        const Server server;
        const std::unique_ptr<TransportLink> link =
            openLink({.kind = Kind::Tcp, .host = "localhost", .port = server.port});
        QVERIFY(!link->isDatagram() && link->peers().empty());
        QVERIFY(isOpened(*link));
        QVERIFY(link->peers() == std::vector<int>{0});
        QCOMPARE(link->peerName(0), "localhost:" + std::to_string(server.port));
        {
            const Descriptor client(::accept(server.socket.get(), nullptr, nullptr));
            link->send(0, kPing);
            std::vector<std::uint8_t> got(3);
            QCOMPARE(::recv(client.get(), got.data(), got.size(), MSG_WAITALL), 3);
            QVERIFY(got == kPing);
            QCOMPARE(::send(client.get(), kPong.data(), kPong.size(), 0), 2);
            const std::optional<LinkPacket> packet = awaited(*link);
            QVERIFY(packet && packet->bytes == kPong);
            // A server that does not read blocks nothing. Of 60 MB only what fits into the buffers
            // of the system (at most 10 MB by default) and of the link arrives.
            for (int i = 0; i < 1000; ++i)
                link->send(0, std::vector<std::uint8_t>(60'000));
            QVERIFY(arriving_bytes(*link, client.get()) < 20'000'000);
        }
        QVERIFY(QTest::qWaitFor([&, &each = link] {
            (void)each->receive();
            return each->condition().state == State::Broken;
        }));
        QVERIFY(!link->condition().fault.empty());
        QVERIFY(isOpened(*link)); // the server still listens
    }

    void missingServerIsAFault()
    {
        int port = 0;
        {
            const Server server;
            port = server.port;
        }
        const std::unique_ptr<TransportLink> link = openLink({.kind = Kind::Tcp, .port = port});
        QVERIFY(QTest::qWaitFor([&, &each = link] {
            return !each->receive() && each->condition().state == State::Broken;
        }));
        QVERIFY(!link->condition().fault.empty());
    }

    void serialPortCarriesBytesAsTheyAre()
    {
        int far = -1;
        int near = -1;
        std::array<char, 64> name{};
        QCOMPARE(::openpty(&far, &near, name.data(), nullptr, nullptr), 0);
        const Descriptor farEnd(far);
        auto nearEnd = std::make_unique<Descriptor>(near);
        const std::unique_ptr<TransportLink> link =
            openLink({.kind = Kind::Serial, .device = name.data()});
        QVERIFY(isOpened(*link));
        nearEnd.reset();
        QCOMPARE(link->peerName(0), std::string(name.data()));
        std::vector<std::uint8_t> all(256);
        std::iota(all.begin(), all.end(), std::uint8_t{0}); // with all control characters
        QCOMPARE(::write(far, all.data(), all.size()), 256);
        std::vector<std::uint8_t> got;
        while (got.size() < all.size()) {
            const std::optional<LinkPacket> packet = awaited(*link);
            QVERIFY(packet);
            got.insert(got.end(), packet->bytes.begin(), packet->bytes.end());
        }
        QVERIFY(got == all);
        link->send(0, all);
        std::fill(got.begin(), got.end(), std::uint8_t{0});
        for (std::size_t at = 0; at < got.size();) {
            const ssize_t length = ::read(far, got.data() + at, got.size() - at);
            QVERIFY(length > 0);
            at += static_cast<std::size_t>(length);
        }
        QVERIFY(got == all);
    }

    void missingPortIsAFault()
    {
        const std::unique_ptr<TransportLink> link =
            openLink({.kind = Kind::Serial, .device = "/dev/no-such-port"});
        QVERIFY(!link->receive());
        QCOMPARE(link->condition().state, State::Broken);
        const std::unique_ptr<TransportLink> file =
            openLink({.kind = Kind::Serial, .device = "/dev/null"});
        QVERIFY(!file->receive());
        QCOMPARE(file->condition().state, State::Broken);
    }

    /** A label of DNS has at most 63 characters, so no name server is asked. */
    void nameThatCannotBeResolvedIsAFault()
    {
        const std::unique_ptr<TransportLink> link =
            openLink({.kind = Kind::Tcp, .host = std::string(70, 'a'), .port = 5760});
        QVERIFY(QTest::qWaitFor([&, &each = link] {
            return !each->receive() && each->condition().state == State::Broken;
        }));
        QVERIFY(!link->condition().fault.empty());
    }
};

QTEST_APPLESS_MAIN(TestTransportLink)
#include "tst_transport_link.moc"
