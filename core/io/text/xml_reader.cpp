#include "core/io/text/xml_reader.h"

#include "core/base/error.h"

#include <algorithm>
#include <exception>
#include <expat.h>
#include <memory>

namespace berg {

namespace {

constexpr std::size_t kDeepest = 64;
constexpr char kNamespaceEnd = '|';

/** Line of the parser's position, from 1. Expat 2.8 deprecates the one function for the other. */
template <class Parser>
std::size_t lineOf(Parser parser)
{
    if constexpr (requires { XML_GetCurrentLineNumber64(parser); })
        return XML_GetCurrentLineNumber64(parser);
    else
        return XML_GetCurrentLineNumber(parser);
}

/** State of one reading; the library calls back with a pointer to it. */
class Reading
{
public:
    Reading(const XmlEvents& events, ReadBudget& budget)
        : m_budget(budget)
        , m_events(events)
        , m_parser(XML_ParserCreateNS(nullptr, kNamespaceEnd), &XML_ParserFree)
    {
        require(m_parser != nullptr, "readXml: no memory for the parser");
        XML_SetUserData(m_parser.get(), this);
        XML_SetElementHandler(m_parser.get(), &Reading::open, &Reading::close);
        XML_SetCharacterDataHandler(m_parser.get(), &Reading::characters);
        XML_SetStartDoctypeDeclHandler(m_parser.get(), &Reading::doctype);
    }

    void run(std::string_view text)
    {
        constexpr std::size_t kPiece = 1U << 16U; // milliseconds
        for (std::size_t at = 0; at == 0 || at < text.size(); at += kPiece) {
            m_budget.goOn();
            const std::string_view piece = text.substr(at, kPiece);
            const bool last = at + piece.size() >= text.size();
            const XML_Status status = XML_Parse(m_parser.get(), piece.data(),
                                                static_cast<int>(piece.size()), last ? 1 : 0);
            if (m_thrown)
                std::rethrow_exception(m_thrown);
            if (status != XML_STATUS_OK)
                fail(XML_ErrorString(XML_GetErrorCode(m_parser.get())));
        }
    }

private:
    [[noreturn]] void fail(const std::string& reason) const
    {
        throw Error(ErrorCode::SyntaxError, m_budget.subject(),
                    {IssueId::XmlSyntax, {countOf(lineOf(m_parser.get())), reason}});
    }

    /** Runs `act`; what it throws ends the reading and waits for `run`: no exception may cross C.
     */
    template <class Act>
    static void guarded(void* data, Act act)
    {
        auto& reading = *static_cast<Reading*>(data);
        if (reading.m_thrown)
            return;
        try {
            act(reading);
        } catch (...) {
            reading.m_thrown = std::current_exception();
            XML_StopParser(reading.m_parser.get(), XML_FALSE);
        }
    }

    static std::string localName(const char* name)
    {
        const std::string_view whole(name);
        return std::string(whole.substr(whole.rfind(kNamespaceEnd) + 1)); // npos + 1 is 0
    }

    static void open(void* data, const char* name, const char** attributes)
    {
        guarded(data, [&](Reading& reading) {
            if (reading.m_path.size() >= kDeepest)
                reading.fail("nested deeper than " + std::to_string(kDeepest) + " levels");
            XmlElement element{.name = localName(name), .line = lineOf(reading.m_parser.get())};
            std::size_t count = 0;
            while (attributes[2 * count] != nullptr)
                ++count;
            constexpr std::size_t kOfLibrary = 64; // about what it takes for each as well
            const std::size_t memory = count * (sizeof(element.attributes.front()) + kOfLibrary);
            reading.m_budget.take(memory);
            reading.m_budget.giveBack(memory); // it is gone with the element
            element.attributes.reserve(count);
            for (const char** pair = attributes; *pair != nullptr; pair += 2)
                element.attributes.emplace_back(localName(pair[0]), pair[1]);
            reading.m_path.push_back(std::move(element));
            if (reading.m_events.opened)
                reading.m_events.opened(reading.m_path);
        });
    }
    static void close(void* data, const char* /*name*/)
    {
        guarded(data, [](Reading& reading) {
            if (reading.m_events.closed)
                reading.m_events.closed(reading.m_path);
            reading.m_path.pop_back();
        });
    }
    static void characters(void* data, const char* text, int length)
    {
        guarded(data, [&](Reading& reading) {
            reading.m_path.back().text.append(text, static_cast<std::size_t>(length));
        });
    }
    static void doctype(void* data, const char* /*name*/, const char* /*systemId*/,
                        const char* /*publicId*/, int /*hasInternalSubset*/)
    {
        guarded(data, [](Reading& reading) {
            reading.fail("a document type declaration (DOCTYPE) is not accepted");
        });
    }

    ReadBudget& m_budget;
    const XmlEvents& m_events;
    std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> m_parser;
    std::vector<XmlElement> m_path;
    std::exception_ptr m_thrown;
};

} // namespace

std::string XmlElement::attribute(std::string_view wanted) const
{
    const auto it = std::find_if(attributes.begin(), attributes.end(),
                                 [&](const auto& pair) { return pair.first == wanted; });
    return it == attributes.end() ? std::string() : it->second;
}

void readXml(std::string_view text, const XmlEvents& events, ReadBudget& budget)
{
    Reading(events, budget).run(text);
}

} // namespace berg
