using System.Text.RegularExpressions;
using Msisf.Adapters.Ephemeris;

namespace Msisf.Adapters.Camera;

/// <summary>The keywords of one instrument in text kernels.</summary>
/// <param name="number">NAIF's number of the instrument.</param>
/// <param name="name">For messages.</param>
internal sealed partial class InstrumentKeywords(KernelPool pool, int number, string name)
{
    /// <summary>What to do where the kernels do not describe a camera.</summary>
    public const string CameraCure = "Give the camera with --camera FILE instead.";

    /// <summary>NAIF's number of the instrument.</summary>
    public int Number { get; } = number;

    /// <summary>For messages.</summary>
    public string Name { get; } = name;

    /// <summary>What all names begin with, e.g. "INS-77_".</summary>
    public string Prefix { get; } = Invariant($"INS{number}_");

    /// <summary>The values of an item, or null.</summary>
    public KernelVariable? Find(string item) => pool.Find(Prefix + item);

    /// <summary>The numbers of an item that must exist.</summary>
    /// <exception cref="BadInputException">Missing, texts, or another count.</exception>
    public double[] Numbers(string item, int count) => Find(item) is null
        ? throw new BadInputException(
            $"No kernel has {Prefix}{item} of {Name}. Add its instrument kernel (IK) with --kernels. {CameraCure}")
        : [.. pool.Numbers(Prefix + item, count)];

    /// <summary>The number of an item that must exist.</summary>
    /// <inheritdoc cref="Numbers" path="/exception"/>
    public double Value(string item) => Numbers(item, 1)[0];

    /// <summary>The whole number of an item that must exist.</summary>
    /// <exception cref="BadInputException">Missing, a text, several values, or not a whole number.</exception>
    public int Whole(string item)
    {
        Numbers(item, 1);
        return pool.WholeNumber(Prefix + item);
    }

    /// <summary>The constant and the two slopes of a transformation, e.g. ITRANSS; null if no kernel has it.</summary>
    /// <exception cref="BadInputException">Not three numbers, or both slopes are 0.</exception>
    public (double Constant, double First, double Second)? Transform(string item)
    {
        if (Find(item) is null)
        {
            return null;
        }

        double[] numbers = Numbers(item, 3);
        return numbers[1] != 0.0 || numbers[2] != 0.0
            ? (numbers[0], numbers[1], numbers[2])
            : throw Wrong(item, "has no direction");
    }

    /// <summary>An error about an item that exists.</summary>
    /// <param name="what">E.g. "is not above 0".</param>
    public BadInputException Wrong(string item, string what) =>
        new($"{pool.Existing(Prefix + item).Source}: {item} of {Name} {what}. {CameraCure}");

    /// <summary>Refuses a keyword that turns the rays of pixels and is not read.</summary>
    /// <param name="read">The items that are.</param>
    /// <exception cref="BadInputException">There is one; zeros do not count.</exception>
    public void RefuseUnread(IReadOnlyCollection<string> read)
    {
        foreach (string item in pool.Names.Where(one => one.StartsWith(Prefix, StringComparison.Ordinal))
            .Select(one => one[Prefix.Length..]).Where(one => !read.Contains(one)).Order(StringComparer.Ordinal))
        {
            if (TurnsRays().IsMatch(item) && !IsOfTime().IsMatch(item) && Find(item)!.Numbers.Any(number => number != 0.0))
            {
                throw Wrong(item, $"turns the rays of its pixels, and no formula is known in which instrument {Number} has it");
            }
        }
    }

    [GeneratedRegex(
        @"^(OD_|DISTORT|DECENT|RADIAL|TANGENT|PERSPECTIVE|POINT_OF_SYM|PRINCIPAL|EULER|CAHV|RESEAU|FIDUCIAL|KAPPA|LENS)|^(PP|XP|YP|CX|CY)$"
            + @"|^(ALPHA|[AJKP])\d+$|(OFFSETS?|SHIFTS?|COEFF?S?|SKEW|TILT|ROTATION|SUMMING|BINNING)$",
        RegexOptions.IgnoreCase | RegexOptions.CultureInvariant)]
    private static partial Regex TurnsRays();

    [GeneratedRegex("TIME|CLOCK|PREROLL|LINE_ERROR", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant)]
    private static partial Regex IsOfTime();
}
