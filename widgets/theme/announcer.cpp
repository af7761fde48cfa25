#include "widgets/theme/announcer.h"

#include "widgets/theme/accessible_roles.h"

#include <algorithm>

namespace berg {
namespace {

constexpr int kInterval_ms = 1000;
constexpr qsizetype kMost = 4; ///< sentences at a time; a fast flight has more than can be heard

} // namespace

Announcer::Announcer(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("announcer"));
    setAccessibleRole(*this, QAccessible::Notification);
    setFixedSize(1, 1);
    m_timer.setSingleShot(true);
    m_timer.setInterval(kInterval_ms);
    connect(&m_timer, &QTimer::timeout, this, &Announcer::tell);
}

void Announcer::say(const QString& text)
{
    m_due << text;
    if (!m_timer.isActive())
        tell();
}

void Announcer::tell()
{
    if (m_due.isEmpty())
        return;
    setAccessibleName(
        m_due.mid(std::max<qsizetype>(0, m_due.size() - kMost)).join(QStringLiteral(". ")));
    m_due.clear();
    m_timer.start();
    // Readers speak a notification when it comes into sight; Qt 6.4 has no other way to say so.
    QAccessibleEvent shown(this, QAccessible::ObjectShow);
    QAccessible::updateAccessibility(&shown);
    emit told(accessibleName());
}

} // namespace berg
