#pragma once

#include "app/window/window_part.h"

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
    /** Where the colours of sigma end: of each scenario its own, or one for all. */
    void buildSigmaEnd(QMenu& menu);
    /** What icebergs that are placed were seen by. */
    void buildSources(QMenu& menu);

signals:
    void languageChosen(const QString& language);
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
