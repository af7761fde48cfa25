// Part of every program of tests that shows words: it speaks English, with its plural forms, on
// every machine.
#include "widgets/theme/language.h"

#include <QCoreApplication>
#include <QLocale>

namespace {

void speakEnglish()
{
    berg::installLanguage(QStringLiteral("en"));
    QLocale::setDefault(QLocale::system()); // numbers stay as they are
}

} // namespace

Q_COREAPP_STARTUP_FUNCTION(speakEnglish)
