#pragma once

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

#include <functional>

namespace berg::test {

/**
 * A vehicle by the npm package node-mavlink, which shares no code with ours, in a process of node
 * (tests/app/link/vehicle.cjs). The package must be in the folder BERGWATCH_NODE_MODULES (see
 * CONTRIBUTING.md). The vehicle has system id 1.
 */
class NodeVehicle
{
public:
    /** Returns false if node or the package is missing. */
    [[nodiscard]] static bool isThere()
    {
        if (!qEnvironmentVariableIsSet("BERGWATCH_NODE_MODULES"))
            qputenv("BERGWATCH_NODE_MODULES", BERG_SOURCE_DIR "/build/node/node_modules");
        return QProcess::execute(QStringLiteral("node"),
                                 {QStringLiteral("-e"),
                                  QStringLiteral("require(process.env.BERGWATCH_NODE_MODULES + "
                                                 "'/node-mavlink')")}) == 0;
    }

    /** Starts a vehicle of kind "ardupilot" or "px4" that sends to a port of this computer. */
    NodeVehicle(int port, const QString& kind, double loss, int seed)
    {
        m_node.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_node.start(QStringLiteral("node"),
                     {QStringLiteral(BERG_SOURCE_DIR "/tests/app/link/vehicle.cjs"),
                      QString::number(port), kind, QString::number(loss), QString::number(seed)});
    }

    ~NodeVehicle()
    {
        m_node.closeWriteChannel(); // it ends then
        m_node.waitForFinished();
    }
    NodeVehicle(const NodeVehicle&) = delete;
    NodeVehicle& operator=(const NodeVehicle&) = delete;

    /** Lets time pass until a condition holds; returns false if it does not. */
    using Wait = std::function<bool(const std::function<bool()>&)>;

    /** Returns the next line that node has written. */
    [[nodiscard]] QJsonObject line(const Wait& until)
    {
        if (!until([this] { return m_node.canReadLine(); }))
            return {};
        return QJsonDocument::fromJson(m_node.readLine()).object();
    }

    /** Returns the number of datagrams that node has received. */
    [[nodiscard]] int datagrams(const Wait& until)
    {
        m_node.write("\n");
        return line(until)[QStringLiteral("datagrams")].toInt(-1);
    }

private:
    QProcess m_node;
};

} // namespace berg::test
