using System.Text;
using Msisf.Adapters.Input;

namespace Msisf.Adapters.Catalogues;

/// <summary>The names of a list's columns, and what parts them.</summary>
public sealed class ListHeader
{
    /// <summary>Spellings of degrees; west longitudes are not among them.</summary>
    internal static readonly string[] UnitsOfAngles = ["", "deg", "degree", "degrees", "°", "dege", "degn", "°e", "°n", "e", "n"];

    private readonly (string Name, string Unit)[] _plain;
    private readonly ListColumns? _given;

    /// <summary>Takes the line with the names.</summary>
    /// <param name="line">The line.</param>
    /// <param name="number">Its number, from 1.</param>
    /// <param name="separator">What parts the names.</param>
    /// <param name="given">Which columns the user names; null for none.</param>
    internal ListHeader(string line, int number, char separator, ListColumns? given)
    {
        (Line, Separator, _given) = (number, separator, given);
        Names = [.. CsvLine.Fields(line, separator).Select(name => name.Trim().ToLowerInvariant())];
        _plain = [.. Names.Select(Plain)];
    }

    /// <summary>The names, in small letters.</summary>
    public IReadOnlyList<string> Names { get; }

    /// <summary>The line that has them, from 1.</summary>
    internal int Line { get; }

    /// <summary>What parts the columns.</summary>
    internal char Separator { get; }

    /// <summary>The first column of the user's that there is none; null if there are all.</summary>
    internal string? Missing => _given?.MissingIn(Names);

    /// <summary>
    /// The place of the column that the user names for a key; otherwise of the first of some names that there is; -1 for none. Capitals,
    /// blanks, '_' and units of angles do not matter: "Center Latitude [deg]" is "center_latitude".
    /// </summary>
    /// <param name="key">As in <see cref="ListColumns"/>.</param>
    /// <param name="names">In small letters, without blanks and signs.</param>
    internal int PlaceOf(string key, params ReadOnlySpan<string> names) => PlaceIn(UnitsOfAngles, key, names);

    /// <summary>The same for columns of a unit.</summary>
    /// <param name="units">The spellings of the unit, behind the name in brackets.</param>
    internal int PlaceIn(string[] units, string key, params ReadOnlySpan<string> names)
    {
        if (_given?.PlaceOf(key, Names) is { } place)
        {
            return place;
        }

        foreach (string name in names)
        {
            int found = Array.FindIndex(_plain, column => column.Name == name && units.Contains(column.Unit));
            if (found >= 0)
            {
                return found;
            }
        }

        return -1;
    }

    /// <summary>The error that a column is missing.</summary>
    /// <param name="what">What for, e.g. "the latitude".</param>
    /// <param name="example">How the columns are named by the option, e.g. "lat=COLUMN,lon=COLUMN".</param>
    internal BadInputException NoColumn(string fileName, string what, string example)
    {
        string columns = string.Join(", ", Names.Where(name => name.Length > 0).Select(name => NumberText.Shown(name)));
        return new BadInputException(Missing is { } missing
            ? $"{fileName}, line {Line}: there is no column {NumberText.Shown(missing)}; there are {columns}."
            : $"{fileName}, line {Line}: no column for {what}. The columns are {(columns.Length > 0 ? columns : "without names")}. Say "
                + $"which one it is: --columns {example}.");
    }

    /// <summary>A name without its unit, blanks and signs, and the unit.</summary>
    private static (string Name, string Unit) Plain(string name)
    {
        int bracket = name.AsSpan().IndexOfAny('(', '[', '<');
        string unit = bracket > 0 && name[^1] is ')' or ']' or '>' ? name[(bracket + 1)..^1] : string.Empty;
        return (Letters(unit.Length > 0 ? name[..bracket] : name), string.Concat(unit.Where(letter => letter is not (' ' or '.' or '_'))));

        static string Letters(string text)
        {
            StringBuilder letters = new(text.Length);
            foreach (char letter in text)
            {
                if (char.IsLetterOrDigit(letter))
                {
                    letters.Append(letter);
                }
            }

            return letters.ToString();
        }
    }
}
