#include "core/io/text/xml_reader.h"

#include "core/base/error.h"
#include "core/io/text/byte_order_mark.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <exception>
#include <expat.h>
#include <memory>

namespace berg {

namespace {

constexpr std::size_t kDeepest = 64;
constexpr char kPrefixEnd = ':';

/** Line of the parser's position, from 1. Expat 2.8 deprecates the one function for the other. */
template <class Parser>
std::size_t lineOf(Parser parser)
{
    if constexpr (requires { XML_GetCurrentLineNumber64(parser); })
        return XML_GetCurrentLineNumber64(parser);
    else
        return XML_GetCurrentLineNumber(parser);
}

/** State of one parse; the library passes a pointer to it to the callbacks. */
class Reading
{
public:
    /** `encoding` overrides the declaration in the text; null keeps the declared encoding. */
    Reading(const XmlEvents& events, ReadBudget& budget, const char* encoding)
        : m_budget(budget), m_events(events), m_parser(XML_ParserCreate(encoding), &XML_ParserFree)
    {
        require(m_parser != nullptr, "readXml: no memory for the parser");
        XML_SetUserData(m_parser.get(), this);
        XML_SetElementHandler(m_parser.get(), &Reading::open, &Reading::close);
        XML_SetCharacterDataHandler(m_parser.get(), &Reading::characters);
        XML_SetStartDoctypeDeclHandler(m_parser.get(), &Reading::doctype);
    }

    void run(std::string_view whole)
    {
        // Blanks before the declaration are a common slip and no reason to reject the file.
        const std::string_view marked = withoutByteOrderMark(whole);
        const std::size_t blanks = std::min(marked.find_first_not_of(" \t\r\n"), marked.size());
        const std::string_view text = marked.substr(blanks);
        m_linesBefore =
            static_cast<std::size_t>(std::ranges::count(marked.substr(0, blanks), '\n'));
        constexpr std::size_t kPiece = 1U << 16U; // takes milliseconds, so a stop is noticed
        for (std::size_t at = 0; at == 0 || at < text.size(); at += kPiece) {
            m_budget.throwIfStopped();
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
                    {IssueId::XmlSyntax, {countOf(line()), reason}});
    }

    [[nodiscard]] std::size_t line() const { return m_linesBefore + lineOf(m_parser.get()); }

    /**
     * Runs `act`. An exception ends the parse and is rethrown by `run`, because none may cross C
     * code.
     */
    template <class Act>
    static void runGuarded(void* data, Act act)
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
        return std::string(whole.substr(whole.rfind(kPrefixEnd) + 1)); // npos + 1 is 0
    }

    static void open(void* data, const char* name, const char** attributes)
    {
        runGuarded(data, [&](Reading& reading) {
            if (reading.m_path.size() >= kDeepest)
                reading.fail("nested deeper than " + std::to_string(kDeepest) + " levels");
            XmlElement element{.name = localName(name), .line = reading.line()};
            std::size_t count = 0;
            while (attributes[2 * count] != nullptr)
                ++count;
            constexpr std::size_t kOfLibrary = 64; // bytes for each in the library, about
            const std::size_t memory = count * (sizeof(element.attributes.front()) + kOfLibrary);
            reading.m_budget.take(memory);
            reading.m_budget.release(memory); // the element is freed again
            element.attributes.reserve(count);
            for (const char** pair = attributes; *pair != nullptr; pair += 2)
                if (!std::string_view(pair[0]).starts_with("xmlns"))
                    element.attributes.emplace_back(localName(pair[0]), pair[1]);
            reading.m_path.push_back(std::move(element));
            if (reading.m_events.opened)
                reading.m_events.opened(reading.m_path);
        });
    }
    static void close(void* data, const char* /*name*/)
    {
        runGuarded(data, [](Reading& reading) {
            if (reading.m_events.closed)
                reading.m_events.closed(reading.m_path);
            reading.m_path.pop_back();
        });
    }
    static void characters(void* data, const char* text, int length)
    {
        runGuarded(data, [&](Reading& reading) {
            reading.m_path.back().text.append(text, static_cast<std::size_t>(length));
        });
    }
    static void doctype(void* data, const char* /*name*/, const char* /*systemId*/,
                        const char* /*publicId*/, int /*hasInternalSubset*/)
    {
        runGuarded(data, [](Reading& reading) {
            reading.fail("a document type declaration (DOCTYPE) is not accepted");
        });
    }

    ReadBudget& m_budget;
    const XmlEvents& m_events;
    std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> m_parser;
    std::size_t m_linesBefore = 0; ///< lines skipped before the text that is passed to the parser
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
    Reading(events, budget, isUtf8(text) ? "UTF-8" : nullptr).run(text);
}

} // namespace berg
