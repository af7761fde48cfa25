#pragma once

#include <QDBusMessage>
#include <QObject>

#include <optional>

namespace berg {

/**
 * Detects whether the desktop is dark or of high contrast, and reports changes. It reads the
 * freedesktop settings portal (org.freedesktop.appearance, color-scheme and contrast), which Qt
 * itself reads only from 6.5 on. Without a portal or a preference it uses the desktop's palette. It
 * never blocks.
 */
class SystemAppearance : public QObject
{
    Q_OBJECT

public:
    explicit SystemAppearance(QObject* parent = nullptr);

    [[nodiscard]] bool isDark() const;
    [[nodiscard]] bool wantsContrast() const { return m_contrast; }

    /** The portal's number: 1 dark, 2 light, all else no preference. */
    void setColourScheme(uint scheme);
    /** The portal's number: 1 higher contrast, all else no preference. */
    void setContrast(uint contrast);

signals:
    void changed();

private slots:
    void settingChanged(const QDBusMessage& message);

private:
    void ask();
    void read(const QString& key, void (SystemAppearance::*answer)(uint));

    bool m_contrast = false;
    std::optional<bool> m_portalDark; ///< nullopt without a portal or a preference
};

} // namespace berg
