#pragma once

#include <QDBusMessage>
#include <QObject>

#include <optional>

namespace berg {

/**
 * Whether the desktop is dark or of high contrast, and when that changes. Asks the freedesktop
 * settings portal (org.freedesktop.appearance, color-scheme and contrast), which Qt asks by itself
 * only from 6.5 on; without a portal, or when it has no preference, the desktop's palette tells.
 * Never waits for an answer.
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
    std::optional<bool> m_portalDark; ///< none: no portal, or no preference
};

} // namespace berg
