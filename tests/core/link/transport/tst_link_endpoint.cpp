#include "core/link/transport/link_endpoint.h"

#include <QtTest>

using namespace berg;

using Kind = LinkEndpoint::Kind;
using Reading = std::variant<LinkEndpoint, EndpointFault>;

class TestLinkEndpoint : public QObject
{
    Q_OBJECT

private slots:
    void textsAreRead_data()
    {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<Reading>("reading");
        QTest::addColumn<std::string>("written");
        const auto row = [](const char* text, const LinkEndpoint& endpoint, const char* written) {
            QTest::newRow(text) << std::string(text) << Reading(endpoint) << std::string(written);
        };
        row("udp", {}, "udp:127.0.0.1:14550");
        row("udp:14551", {.port = 14551}, "udp:127.0.0.1:14551");
        row("udpin:0.0.0.0:14550", {.host = "0.0.0.0"}, "udp:0.0.0.0:14550");
        row("udp:localhost", {.host = "localhost"}, "udp:localhost:14550");
        row("udpout:10.0.0.7:14550", {.kind = Kind::UdpSend, .host = "10.0.0.7"},
            "udpout:10.0.0.7:14550");
        row("tcp:", {.kind = Kind::Tcp, .port = 5760}, "tcp:127.0.0.1:5760");
        row("tcp:ground-1.example:5763",
            {.kind = Kind::Tcp, .host = "ground-1.example", .port = 5763},
            "tcp:ground-1.example:5763");
        row("serial:/dev/ttyUSB0", {.kind = Kind::Serial, .device = "/dev/ttyUSB0"},
            "serial:/dev/ttyUSB0:57600");
        row("serial:/dev/ttyUSB0:4800",
            {.kind = Kind::Serial, .device = "/dev/ttyUSB0", .baud = 4800},
            "serial:/dev/ttyUSB0:4800");
        row("serial:/dev/serial/by-path/pci-0:1.0:115200",
            {.kind = Kind::Serial, .device = "/dev/serial/by-path/pci-0:1.0", .baud = 115200},
            "serial:/dev/serial/by-path/pci-0:1.0:115200");
    }

    void textsAreRead()
    {
        QFETCH(std::string, text);
        QFETCH(Reading, reading);
        QFETCH(std::string, written);
        QVERIFY(readEndpoint(text) == reading);
        QCOMPARE(endpointText(std::get<LinkEndpoint>(reading)), written);
        QVERIFY(readEndpoint(written) == reading);
    }

    void otherTextsAreFaults_data()
    {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<EndpointFault>("fault");
        const auto row = [](const char* text, EndpointFault fault) {
            QTest::newRow(text) << std::string(text) << fault;
        };
        row("", EndpointFault::Kind);
        row("14550", EndpointFault::Kind);
        row("UDP:14550", EndpointFault::Kind);
        row("udp:0", EndpointFault::Port);
        row("udp:127.0.0.1:65536", EndpointFault::Port);
        row("udp:127.0.0.1:", EndpointFault::Port);
        row("udp:127.0.0.1:145x", EndpointFault::Port);
        row("udp:127.0.0.1:-1", EndpointFault::Port);
        row("tcp::5760", EndpointFault::Host);
        row("tcp:a b:5760", EndpointFault::Host);
        row("udp:[::1]:14550", EndpointFault::Host);
        row("serial:", EndpointFault::Device);
        row("serial:ttyUSB0", EndpointFault::Device);
        row("serial:/dev/ttyUSB0:57601", EndpointFault::Baud);
        row("serial:/dev/ttyUSB0:fast", EndpointFault::Baud);
    }

    void otherTextsAreFaults()
    {
        QFETCH(std::string, text);
        QFETCH(EndpointFault, fault);
        QVERIFY(readEndpoint(text) == Reading(fault));
        QVERIFY(englishWords(fault).starts_with("%1 "));
    }

    void onlyTheNetworkIsNotLocal()
    {
        QVERIFY(isLocal(LinkEndpoint{}));
        QVERIFY(isLocal({.host = "localhost"}));
        QVERIFY(isLocal({.host = "127.0.0.2"}));
        QVERIFY(!isLocal({.host = "127.example.com"}));
        QVERIFY(!isLocal({.host = "127.0.0.1.example.com"}));
        QVERIFY(isLocal({.kind = Kind::Serial, .host = "", .device = "/dev/ttyUSB0"}));
        QVERIFY(!isLocal({.host = "0.0.0.0"}));
        QVERIFY(!isLocal({.kind = Kind::Tcp, .host = "10.0.0.7"}));
    }
};

QTEST_APPLESS_MAIN(TestLinkEndpoint)
#include "tst_link_endpoint.moc"
