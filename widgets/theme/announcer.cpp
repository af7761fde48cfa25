#include "widgets/theme/announcer.h"

#include "widgets/theme/accessible_roles.h"

#include <algorithm>

namespace berg {
namespace {

constexpr int kInterval_ms = 1000;
constexpr qsizetype kMost = 4; // sentences per announcement; fast flights have too many to hear

} // namespace

Announcer::Announcer(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("announcer"));
    setAccessibleRole(*this, QAccessible::Notification);
    setFixedSize(1, 1);
    m_timer.setSingleShot(true);
    m_timer.setInterval(kInterval_ms);
    connect(&m_timer, &QTimer::timeout, this, &Announcer::announce);
}

void Announcer::say(const QString& text)
{
    m_due << text;
    if (!m_timer.isActive())
        announce();
}

void Announcer::announce()
{
    if (m_due.isEmpty())
        return;
    setAccessibleName(
        m_due.mid(std::max<qsizetype>(0, m_due.size() - kMost)).join(QStringLiteral(". ")));
    m_due.clear();
    m_timer.start();
    // Screen readers speak a notification when it is shown; Qt 6.4 has no dedicated event.
    QAccessibleEvent shown(this, QAccessible::ObjectShow);
    QAccessible::updateAccessibility(&shown);
    emit announced(accessibleName());
}

} // namespace berg
