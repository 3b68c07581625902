using System.Text;
using Msisf.Adapters.Input;

namespace Msisf.Adapters.Catalogues;

/// <summary>
/// A list of craters or places: text above the names of the columns, the names, and a row for each. Commas, semicolons, tabs or '|' part
/// the columns; lines that begin with '#', '%' or '!' are comments.
/// </summary>
internal sealed class ListTable
{
    /// <summary>Lines above the names of the columns; more are another kind of file.</summary>
    private const int MostLinesAbove = 200;

    private static readonly char[] Separators = [',', '\t', ';', '|'];

    private readonly LineSource _lines;
    private readonly string _fileName;

    private ListTable(LineSource lines, string fileName, ListHeader header) => (_lines, _fileName, Header) = (lines, fileName, header);

    /// <summary>The names of the columns.</summary>
    public ListHeader Header { get; }

    /// <summary>The rows.</summary>
    public IEnumerable<CsvRow> Rows => CsvRow.Of(_lines, _fileName, Header);

    /// <summary>Looks for the names of the columns.</summary>
    /// <param name="reader">The text, from its beginning.</param>
    /// <param name="fileName">For messages.</param>
    /// <param name="given">Which columns the user names; null for none.</param>
    /// <param name="isHeader">Whether columns are those of such a list.</param>
    /// <returns>The table; if no line has such names, with those of the first line that is not a comment.</returns>
    public static ListTable Open(TextReader reader, string fileName, ListColumns? given, Func<ListHeader, bool> isHeader)
    {
        LineSource lines = new(reader);
        ListHeader? first = null;
        while (lines.Number < MostLinesAbove && lines.Read() is { } line)
        {
            foreach (char separator in Separators)
            {
                ListHeader header = new(line, lines.Number, separator, given);
                if (header.Missing is null && isHeader(header))
                {
                    if (given is { AreNumbers: true } && header.Names.Any(name => NumberText.TryParse(name, out _)))
                    {
                        lines.Return(line); // no names at all: this is a row
                    }

                    return new ListTable(lines, fileName, header);
                }

                if (header.Names.Count > 1 && (first is null || (first.Line == header.Line && header.Names.Count > first.Names.Count)))
                {
                    first = header;
                }
            }
        }

        return new ListTable(lines, fileName, first ?? new ListHeader(string.Empty, 1, ',', given));
    }

    /// <summary>Opens a list in whichever encoding it is: UTF-8, UTF-16 with a byte order mark, otherwise ISO 8859-1.</summary>
    /// <typeparam name="T">What is read of it.</typeparam>
    /// <param name="what">What is needed, for messages.</param>
    /// <exception cref="BadInputException">It can't be read, or is of a format that is known, but not read.</exception>
    public static T Read<T>(string path, string what, Func<TextReader, T> read) => !File.Exists(path)
        ? throw new BadInputException(
            $"{path}: {(Directory.Exists(path) ? "is a folder" : "there is no such file")}. {what} in CSV is needed.")
        : FileErrors.ToBadInput($"{path}: can't be read", () =>
        {
            KnownFormats.Refuse(path, FormatUse.List);
            using StreamReader reader = new(path, IsUtf8(path) ? Encoding.UTF8 : Encoding.Latin1);
            return read(reader);
        });

    private static bool IsUtf8(string path)
    {
        using StreamReader reader = new(path, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false, throwOnInvalidBytes: true));
        char[] buffer = new char[1 << 16];
        try
        {
            while (reader.Read(buffer) > 0)
            {
                // Only whether it can be decoded counts.
            }

            return true;
        }
        catch (DecoderFallbackException)
        {
            return false;
        }
    }

    /// <summary>The lines that are not empty and no comments.</summary>
    /// <param name="reader">The text.</param>
    internal sealed class LineSource(TextReader reader)
    {
        private string? _returned;

        /// <summary>Number of the line read last, from 1.</summary>
        public int Number { get; private set; }

        /// <summary>Gives the line read last once more.</summary>
        public void Return(string line) => (_returned, Number) = (line, Number - 1);

        /// <summary>The next line; null at the end.</summary>
        public string? Read()
        {
            string? line;
            do
            {
                line = ReadAny();
            }
            while (line is not null && (line.Trim().Length == 0 || line.TrimStart()[0] is '#' or '%' or '!'));
            return line;
        }

        /// <summary>The next line, whatever it is; null at the end.</summary>
        public string? ReadAny()
        {
            string? line = _returned ?? reader.ReadLine();
            _returned = null;
            Number += line is null ? 0 : 1;
            return line;
        }
    }
}
