#include "widgets/theme/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace berg {

using namespace Qt::StringLiterals;

namespace {

/**
 * Returns the locale for a language: with the user's country if the languages agree; otherwise
 * English is British, which writes the day before the month and uses 24 hours.
 */
QLocale localeOf(const std::optional<QString>& language)
{
    const QLocale system = QLocale::system();
    if (!language)
        return system;
    const QLocale chosen(*language);
    if (chosen.language() == system.language())
        return system;
    return chosen.language() == QLocale::English ? QLocale(QLocale::English, QLocale::UnitedKingdom)
                                                 : chosen;
}

} // namespace

void installLanguage(const std::optional<QString>& language)
{
    static QTranslator own;
    static QTranslator qt;
    QCoreApplication::removeTranslator(&own);
    QCoreApplication::removeTranslator(&qt);
    const QLocale locale = localeOf(language);
    QLocale::setDefault(locale);
    for (const QLocale& spoken : {locale, QLocale(QLocale::English)})
        if (own.load(spoken, u"bergwatch"_s, u"_"_s, u":/i18n"_s)) {
            QCoreApplication::installTranslator(&own);
            break;
        }
    if (qt.load(locale, u"qt"_s, u"_"_s, u":/i18n"_s) ||
        qt.load(locale, u"qtbase"_s, u"_"_s, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&qt);
}

} // namespace berg
