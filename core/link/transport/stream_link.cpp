#include "core/link/transport/stream_link.h"

#include "core/link/transport/link_clock.h"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <system_error>
#include <termios.h>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kPieceRead = 4096;
constexpr std::size_t kMostUnsent = 65536;
constexpr double kConnect_s = 10;

/** Returns the constant of termios for a baud rate that `readEndpoint` accepts. */
speed_t speedOf(int baud)
{
    constexpr std::array<std::pair<int, speed_t>, 11> kSpeeds{{{4800, B4800},
                                                               {9600, B9600},
                                                               {19200, B19200},
                                                               {38400, B38400},
                                                               {57600, B57600},
                                                               {115200, B115200},
                                                               {230400, B230400},
                                                               {460800, B460800},
                                                               {500000, B500000},
                                                               {921600, B921600},
                                                               {1000000, B1000000}}};
    for (const auto& [rate, speed] : kSpeeds)
        if (rate == baud)
            return speed;
    return B57600;
}

/** Sets 8 data bits, no parity, one stop bit, no flow control, and bytes as they are. */
bool setRaw(int fd, int baud)
{
    termios settings{};
    if (::tcgetattr(fd, &settings) != 0)
        return false;
    ::cfmakeraw(&settings);
    settings.c_cflag |= CLOCAL | CREAD;
    settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
    ::cfsetispeed(&settings, speedOf(baud));
    ::cfsetospeed(&settings, speedOf(baud));
    return ::tcsetattr(fd, TCSANOW, &settings) == 0;
}

std::string systemWords(int error)
{
    return std::generic_category().message(error);
}

} // namespace

StreamLink::StreamLink(const LinkEndpoint& endpoint) : m_endpoint(endpoint)
{
    if (endpoint.kind == LinkEndpoint::Kind::Tcp)
        m_lookup.emplace(endpoint);
}

void StreamLink::breakDown(const std::string& fault)
{
    m_file.reset();
    m_unsent.clear();
    m_condition = {.state = LinkCondition::State::Broken, .fault = fault};
    m_retry_s = monotonicNow_s() + kReopen_s;
    if (m_lookup) // the server may have moved to another address
        m_lookup.emplace(m_endpoint);
}

void StreamLink::open()
{
    if (isOpen())
        return;
    if (m_file)
        finishConnection();
    else if (monotonicNow_s() >= m_retry_s && m_lookup)
        connectToServer();
    else if (monotonicNow_s() >= m_retry_s)
        openSerial();
}

void StreamLink::openSerial()
{
    m_file.emplace(::open(m_endpoint.device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    // Another program that reads the port would take bytes away.
    if (!m_file->isOpen() || !setRaw(m_file->get(), m_endpoint.baud) ||
        ::ioctl(m_file->get(), TIOCEXCL) != 0) {
        breakDown(systemWords(errno));
        return;
    }
    m_condition = {.state = LinkCondition::State::Open};
}

void StreamLink::connectToServer()
{
    m_condition.state = LinkCondition::State::Opening;
    if (!m_lookup->isDone())
        return;
    const std::optional<sockaddr_in> address = m_lookup->address();
    if (!address) {
        breakDown(m_lookup->fault());
        return;
    }
    m_file.emplace(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    m_started_s = monotonicNow_s();
    if (!m_file->isOpen() || (::connect(m_file->get(), reinterpret_cast<const sockaddr*>(&*address),
                                        sizeof *address) != 0 &&
                              errno != EINPROGRESS))
        breakDown(systemWords(errno));
}

void StreamLink::finishConnection()
{
    pollfd waiting{.fd = m_file->get(), .events = POLLOUT, .revents = 0};
    if (::poll(&waiting, 1, 0) <= 0) {
        if (monotonicNow_s() - m_started_s > kConnect_s)
            breakDown(systemWords(ETIMEDOUT));
        return;
    }
    int error = 0;
    socklen_t size = sizeof error;
    ::getsockopt(m_file->get(), SOL_SOCKET, SO_ERROR, &error, &size);
    if (error != 0) {
        breakDown(systemWords(error));
        return;
    }
    const int isOn = 1; // frames are small and must not wait
    ::setsockopt(m_file->get(), IPPROTO_TCP, TCP_NODELAY, &isOn, sizeof isOn);
    m_condition = {.state = LinkCondition::State::Open};
}

std::optional<LinkPacket> StreamLink::receive()
{
    open();
    if (!isOpen())
        return std::nullopt;
    flush();
    if (!isOpen())
        return std::nullopt;
    LinkPacket packet{.peer = 0, .bytes = std::vector<std::uint8_t>(kPieceRead)};
    const ssize_t length = ::read(m_file->get(), packet.bytes.data(), packet.bytes.size());
    if (length > 0) {
        packet.bytes.resize(static_cast<std::size_t>(length));
        return packet;
    }
    // A serial port without data may report an end; it has ended only if it has hung up.
    pollfd state{.fd = m_file->get(), .events = 0, .revents = 0};
    const bool isEnded =
        length == 0 && (m_lookup || (::poll(&state, 1, 0) > 0 && (state.revents & POLLHUP) != 0));
    if (isEnded)
        breakDown(systemWords(ENOTCONN));
    else if (length < 0 && errno != EAGAIN && errno != EINTR)
        breakDown(systemWords(errno));
    return std::nullopt;
}

std::vector<int> StreamLink::peers() const
{
    return isOpen() ? std::vector<int>{0} : std::vector<int>{};
}

void StreamLink::send(int peer, std::span<const std::uint8_t> bytes)
{
    if (peer != 0 || !isOpen() || m_unsent.size() + bytes.size() > kMostUnsent)
        return;
    m_unsent.insert(m_unsent.end(), bytes.begin(), bytes.end());
    flush();
}

void StreamLink::flush()
{
    while (!m_unsent.empty()) {
        const ssize_t written =
            m_lookup ? ::send(m_file->get(), m_unsent.data(), m_unsent.size(), MSG_NOSIGNAL)
                     : ::write(m_file->get(), m_unsent.data(), m_unsent.size());
        if (written < 0) {
            if (errno != EAGAIN && errno != EINTR)
                breakDown(systemWords(errno));
            return;
        }
        if (written == 0)
            return; // so some serial drivers report a full buffer
        m_unsent.erase(m_unsent.begin(), m_unsent.begin() + written);
    }
}

std::string StreamLink::peerName(int peer) const
{
    if (peer != 0)
        return {};
    return m_lookup ? m_endpoint.host + ':' + std::to_string(m_endpoint.port) : m_endpoint.device;
}

} // namespace berg
