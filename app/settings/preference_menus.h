#pragma once

#include "app/layout/window_part.h"

#include <optional>

class QAction;
class QMenu;

namespace berg {

class AppearanceChoice;

/** Menus in which one of several choices is in force: appearance, units, language. */
class PreferenceMenus : public WindowPart
{
    Q_OBJECT

public:
    PreferenceMenus(WindowContext& context, AppearanceChoice& appearance);

    void build(QMenu& menu);
    /** Fills a menu that chooses where the colours of sigma end, by scenario or for all of them. */
    void buildSigmaEnd(QMenu& menu);
    /** Fills a menu that chooses what sees new icebergs, and so how uncertain they are. */
    void buildSources(QMenu& menu);

signals:
    /** Emitted when a language was chosen; nullopt is the system's. */
    void languageChosen(const std::optional<QString>& language);
    void unitsChosen();
    void sigmaEndChosen();

private:
    void buildAppearance(QMenu& menu);
    void buildScale(QMenu& menu);
    void buildUnits(QMenu& menu);
    void buildNorth(QMenu& menu);
    void chooseNorth(const QAction& action);
    void buildLanguage(QMenu& menu);
    void addChoice(QMenu& menu, const QString& text, const QString& key, const QString& value);

    void useSavedSource();

    AppearanceChoice& m_appearance;
};

} // namespace berg
