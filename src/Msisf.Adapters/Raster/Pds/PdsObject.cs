using System.Globalization;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Raster.Pds;

/// <summary>An OBJECT or GROUP of a PDS3 label, or the label itself: keywords with their values, and objects inside it.</summary>
public sealed class PdsObject
{
    private readonly Dictionary<string, PdsValue> _values = new(StringComparer.Ordinal);
    private readonly List<PdsObject> _children = [];
    private readonly string _file;

    /// <summary>Makes an empty object.</summary>
    /// <param name="file">Name of the label's file for messages.</param>
    /// <param name="name">Name of the object.</param>
    /// <param name="line">Line where it begins, from 1.</param>
    internal PdsObject(string file, string name, int line)
    {
        _file = file;
        Name = name;
        Line = line;
    }

    /// <summary>Name of the object, e.g. "IMAGE_MAP_PROJECTION".</summary>
    public string Name { get; }

    /// <summary>Line where it begins, from 1.</summary>
    public int Line { get; }

    /// <summary>The value of a keyword of this object itself; null if it has none.</summary>
    public PdsValue? Find(string keyword) => _values.GetValueOrDefault(keyword);

    /// <summary>The first object of a name, in the order of the label, however deep; null if there is none.</summary>
    public PdsObject? FindObject(string name)
    {
        foreach (PdsObject child in _children)
        {
            if ((child.Name == name ? child : child.FindObject(name)) is { } found)
            {
                return found;
            }
        }

        return null;
    }

    /// <summary>The value of a keyword that must be there.</summary>
    /// <exception cref="BadInputException">It is missing.</exception>
    public PdsValue Required(string keyword) => Find(keyword)
        ?? throw new BadInputException($"{_file}: {Name} has no {keyword}. Get the label again from the archive that holds the product.");

    /// <summary>The one-line text of a keyword that must be there.</summary>
    /// <exception cref="BadInputException">It is missing, empty or a sequence.</exception>
    public string RequiredText(string keyword)
    {
        PdsValue value = Required(keyword);
        return value.Items is null && value.Text.Length > 0 ? value.ToString() : throw WrongValue(keyword, value, "one text is needed");
    }

    /// <summary>The number of a keyword that must be there; its unit, if it has one, must be one of the given spellings.</summary>
    /// <exception cref="BadInputException">It is missing, no finite number, or has another unit.</exception>
    public double RequiredNumber(string keyword, params string[] units) => Number(keyword, Required(keyword), units);

    /// <summary>The number of a keyword; null if it is missing or 'N/A'.</summary>
    /// <exception cref="BadInputException">It is no finite number, or has another unit.</exception>
    public double? OptionalNumber(string keyword, params string[] units) =>
        Find(keyword) is { Text: not "N/A" } value ? Number(keyword, value, units) : null;

    /// <summary>The whole number of a keyword that must be there.</summary>
    /// <exception cref="BadInputException">It is missing, no whole number, or out of range.</exception>
    public int RequiredInteger(string keyword, int minimum, int maximum) => Integer(keyword, Required(keyword), minimum, maximum);

    /// <summary>The whole number of a keyword; null if it is missing.</summary>
    /// <exception cref="BadInputException">It is no whole number, or out of range.</exception>
    public int? OptionalInteger(string keyword, int minimum, int maximum) =>
        Find(keyword) is { } value ? Integer(keyword, value, minimum, maximum) : null;

    /// <summary>The error for a value that is not allowed.</summary>
    /// <param name="keyword">The keyword.</param>
    /// <param name="value">Its value.</param>
    /// <param name="need">What is needed instead.</param>
    public BadInputException WrongValue(string keyword, PdsValue value, string need) => new(string.Create(
        CultureInfo.InvariantCulture, $"{_file}, line {value.Line}: {keyword} = {value}; {need}."));

    /// <summary>Adds a keyword while the label is read.</summary>
    /// <exception cref="BadInputException">The object has the keyword already, with another value.</exception>
    internal void Add(string keyword, PdsValue value)
    {
        if (!_values.TryAdd(keyword, value) && _values[keyword].ToString() != value.ToString())
        {
            throw WrongValue(keyword, value, string.Create(
                CultureInfo.InvariantCulture, $"line {_values[keyword].Line} of the same object says {_values[keyword]}"));
        }
    }

    /// <summary>Adds an object while the label is read.</summary>
    internal void Add(PdsObject child) => _children.Add(child);

    private double Number(string keyword, PdsValue value, string[] units)
    {
        if (value.Items is not null || value.IsQuoted || !TryParse(value.Text, out double number))
        {
            throw WrongValue(keyword, value, "a finite number is needed");
        }

        return units.Length == 0 || value.Unit is null || units.Contains(value.Unit, StringComparer.OrdinalIgnoreCase)
            ? number
            : throw WrongValue(keyword, value, $"the unit <{units[0]}> is needed");
    }

    private int Integer(string keyword, PdsValue value, int minimum, int maximum)
    {
        double number = Number(keyword, value, []);
        return number == Math.Floor(number) && number >= minimum && number <= maximum
            ? (int)number
            : throw WrongValue(keyword, value, string.Create(
                CultureInfo.InvariantCulture, $"a whole number from {minimum} to {maximum} is needed"));
    }

    private static bool TryParse(string text, out double number) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out number) && double.IsFinite(number);
}
