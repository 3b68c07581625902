namespace Msisf.Adapters.Ephemeris;

/// <summary>Names and numbers of bodies, spacecraft and instruments, as NAIF has them and as text kernels add them. Immutable.</summary>
public sealed class BodyNames
{
    private const string NamesVariable = "NAIF_BODY_NAME";
    private const string CodesVariable = "NAIF_BODY_CODE";

    /// <summary>Those of CSPICE's own list that a camera near the Moon may meet (NAIF Integer ID Codes); the usual name first.</summary>
    internal static IReadOnlyList<(string Name, int Number)> BuiltIn { get; } =
    [
        ("SOLAR SYSTEM BARYCENTER", 0), ("SSB", 0), ("MERCURY BARYCENTER", 1), ("VENUS BARYCENTER", 2),
        ("EARTH BARYCENTER", 3), ("EMB", 3), ("EARTH MOON BARYCENTER", 3), ("MARS BARYCENTER", 4), ("JUPITER BARYCENTER", 5),
        ("SATURN BARYCENTER", 6), ("URANUS BARYCENTER", 7), ("NEPTUNE BARYCENTER", 8), ("PLUTO BARYCENTER", 9),
        ("SUN", 10), ("MERCURY", 199), ("VENUS", 299), ("MOON", 301), ("EARTH", 399), ("MARS", 499), ("PHOBOS", 401), ("DEIMOS", 402),
        ("JUPITER", 599), ("IO", 501), ("EUROPA", 502), ("GANYMEDE", 503), ("CALLISTO", 504), ("SATURN", 699), ("URANUS", 799),
        ("NEPTUNE", 899), ("PLUTO", 999),
        ("LRO", -85), ("LUNAR RECONNAISSANCE ORBITER", -85), ("LUNAR RECON ORBITER", -85), ("LCROSS", -18), ("LADEE", -12),
        ("LUNAR PROSPECTOR", -25), ("LP", -25), ("CLEMENTINE", -40), ("CHANDRAYAAN-1", -86), ("SELENE", -131), ("KAGUYA", -131),
        ("GRAIL-A", -177), ("GRAIL-B", -181), ("SMART-1", -238), ("SMART1", -238), ("KPLO", -155),
        ("GALILEO ORBITER", -77), ("GLL", -77), ("CASSINI", -82), ("ROSETTA", -226),
        ("MARS EXPRESS", -41), ("MEX", -41), ("MESSENGER", -236), ("BEPICOLOMBO MPO", -121), ("JUNO", -61), ("JUICE", -28),
        ("EUROPA CLIPPER", -159),
    ];

    private readonly Dictionary<string, int> _numbers = new(StringComparer.Ordinal);
    private readonly Dictionary<int, string> _names = [];

    /// <summary>Takes NAIF's names, and those of kernels before them.</summary>
    /// <param name="pool">May have NAIF_BODY_NAME and NAIF_BODY_CODE.</param>
    /// <exception cref="BadInputException">There are not as many names as codes.</exception>
    public BodyNames(KernelPool pool)
    {
        foreach ((string name, int number) in BuiltIn)
        {
            _numbers[name] = number;
            _names.TryAdd(number, name);
        }

        IReadOnlyList<string> names = pool.Find(NamesVariable)?.Texts ?? [];
        IReadOnlyList<double> codes = pool.Find(CodesVariable)?.Numbers ?? [];
        if (names.Count != codes.Count)
        {
            throw new BadInputException(
                $"{(pool.Find(NamesVariable) ?? pool.Existing(CodesVariable)).Source}: {names.Count} {NamesVariable} and {codes.Count} "
                    + $"{CodesVariable}; each name needs one code.");
        }

        HashSet<int> named = [];
        for (int i = 0; i < names.Count; i++)
        {
            int number = (int)codes[i];
            string name = Normalized(names[i]);
            _numbers[name] = number;
            if (named.Add(number) || !_names.ContainsKey(number))
            {
                _names[number] = name;
            }
        }
    }

    /// <summary>The number of a name, or of the digits of a number; null if no list has the name.</summary>
    public int? NumberOf(string nameOrId) =>
        int.TryParse(nameOrId, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int number) ? number
        : _numbers.TryGetValue(Normalized(nameOrId), out int found) ? found
        : null;

    /// <summary>The name of a number; null if no list has it.</summary>
    public string? NameOf(int number) => _names.GetValueOrDefault(number);

    /// <summary>"LRO (-85)", or "-123456" where there is no name.</summary>
    public string Describe(int number) => NameOf(number) is { } name
        ? Invariant($"{name} ({number})")
        : number.ToString(CultureInfo.InvariantCulture);

    /// <summary>In SPICE names differ neither by case nor by the number of blanks.</summary>
    private static string Normalized(string name) =>
        string.Join(' ', name.ToUpperInvariant().Split(' ', StringSplitOptions.RemoveEmptyEntries));
}
