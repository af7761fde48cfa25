#include "app/settings/system_appearance.h"

#include "widgets/theme/palette.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>
#include <QGuiApplication>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr uint kPrefersDark = 1;
constexpr uint kPrefersLight = 2;
constexpr uint kPrefersContrast = 1;

constexpr QLatin1StringView kService("org.freedesktop.portal.Desktop");
constexpr QLatin1StringView kPath("/org/freedesktop/portal/desktop");
constexpr QLatin1StringView kInterface("org.freedesktop.portal.Settings");
constexpr QLatin1StringView kSpace("org.freedesktop.appearance");
constexpr QLatin1StringView kSchemeKey("color-scheme");
constexpr QLatin1StringView kContrastKey("contrast");

/** The portal of old answers with a variant inside a variant. */
uint numberOf(const QVariant& value)
{
    if (value.canConvert<QDBusVariant>())
        return numberOf(value.value<QDBusVariant>().variant());
    return value.toUInt();
}

} // namespace

SystemAppearance::SystemAppearance(QObject* parent) : QObject(parent)
{
    // Pictures made without a screen must not depend on the desktop they are made on.
    if (QGuiApplication::platformName() != u"offscreen"_s)
        ask();
}

void SystemAppearance::ask()
{
    QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected())
        return;
    // The message as it is: in Qt 6.4 a slot with three arguments is not always taken.
    bus.connect(kService, kPath, kInterface, u"SettingChanged"_s, this,
                SLOT(settingChanged(QDBusMessage)));
    read(kSchemeKey, &SystemAppearance::setColourScheme);
    read(kContrastKey, &SystemAppearance::setContrast);
}

void SystemAppearance::read(const QString& key, void (SystemAppearance::*answer)(uint))
{
    QDBusMessage call = QDBusMessage::createMethodCall(kService, kPath, kInterface, u"Read"_s);
    call << QString(kSpace) << key;
    auto* watcher =
        new QDBusPendingCallWatcher(QDBusConnection::sessionBus().asyncCall(call), this);
    connect(watcher, &QDBusPendingCallWatcher::finished, this, [this, watcher, answer] {
        const QDBusPendingReply<QDBusVariant> reply = *watcher;
        if (!reply.isError())
            (this->*answer)(numberOf(reply.value().variant()));
        watcher->deleteLater();
    });
}

void SystemAppearance::settingChanged(const QDBusMessage& message)
{
    const QVariantList said = message.arguments(); // space, key, value
    if (said.size() != 3 || said[0].toString() != kSpace)
        return;
    if (said[1].toString() == kSchemeKey)
        setColourScheme(numberOf(said[2]));
    else if (said[1].toString() == kContrastKey)
        setContrast(numberOf(said[2]));
}

void SystemAppearance::setContrast(uint contrast)
{
    if (m_contrast == (contrast == kPrefersContrast))
        return;
    m_contrast = !m_contrast;
    emit changed();
}

void SystemAppearance::setColourScheme(uint scheme)
{
    const bool wasDark = isDark();
    m_portalDark.reset();
    if (scheme == kPrefersDark || scheme == kPrefersLight)
        m_portalDark = scheme == kPrefersDark;
    if (isDark() != wasDark)
        emit changed();
}

bool SystemAppearance::isDark() const
{
    return m_portalDark.value_or(systemPaletteIsDark());
}

} // namespace berg
