namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>A satellite's states, written by CSPICE in each type of SPK.</summary>
internal static class SpkSamples
{
    public const int Body = -999;

    private const int Moon = 301;
    private const double Begin = 3.02e8;
    private const double Step = 60.0;
    private const int Count = 250;

    public static string[] Kinds { get; } =
    [
        "1", "2", "3", "5", "5 hyperbola", "8 degree 7", "8 degree 6", "9 degree 11", "9 degree 4", "12 degree 7", "12 degree 5",
        "13 degree 15", "13 degree 9", "18 Hermite", "18 Lagrange", "21", "13 ECLIPJ2000", "9 MOON_ME",
    ];

    public static double[] Epochs(string kind) => kind.Split(' ')[0] is "2" or "3" or "8" or "12"
        ? [.. Enumerable.Range(0, Count).Select(i => Begin + (i * Step))]
        : [.. Enumerable.Range(0, Count).Select(i => Begin + (i * Step) + (17.0 * Math.Sin(i)))];

    /// <summary>An orbit of 100 km height, with an acceleration for type 18, along turned axes.</summary>
    private static double[] State(double time, bool hasAcceleration)
    {
        double angle = 8.9e-4 * (time - Begin);
        (double r, double w) = (1840.0 + (12.0 * Math.Sin(0.3 * angle)), 8.9e-4);
        (double s, double c) = Math.SinCos(angle);
        double[] state = [r * c, r * s * 0.6, r * s * 0.8, -r * w * s, r * w * c * 0.6, r * w * c * 0.8];
        return hasAcceleration
            ? [.. state, -r * w * s, r * w * c * 0.6, r * w * c * 0.8, -r * w * w * c, -r * w * w * s * 0.6, -r * w * w * s * 0.8]
            : state;
    }

    public static void Write(int handle, string kind)
    {
        double[] epochs = Epochs(kind);
        (double first, double last) = (epochs[0], epochs[^1]);
        string[] words = kind.Split(' ');
        byte[] frame = SpiceItself.Bytes(words[^1] is "ECLIPJ2000" or "MOON_ME" ? words[^1] : "J2000");
        byte[] id = SpiceItself.Bytes("test");
        int degree = words is [_, "degree", var digits] ? int.Parse(digits, System.Globalization.CultureInfo.InvariantCulture) : 7;
        double[] states = [.. epochs.SelectMany(time => State(time, hasAcceleration: false))];
        double fastest = words is [_, "hyperbola"] ? 1000.0 : 4902.8;
        switch (words[0])
        {
            case "1":
            case "21":
                WriteDifferences(handle, epochs, words[0] == "1" ? 15 : 22, id);
                break;
            case "2":
                SpiceItself.spkw02_c(
                    handle, Body, Moon, frame, first, last, id, Step, Count - 1, 5, Series()[..((Count - 1) * 18)], Begin);
                break;
            case "3":
                SpiceItself.spkw03_c(handle, Body, Moon, frame, first, last, id, Step, Count - 1, 5, Series(), Begin);
                break;
            case "5":
                SpiceItself.spkw05_c(handle, Body, Moon, frame, first, last, id, fastest, Count, states, epochs);
                break;
            case "8":
                SpiceItself.spkw08_c(handle, Body, Moon, frame, first, last, id, degree, Count, states, Begin, Step);
                break;
            case "9":
                SpiceItself.spkw09_c(handle, Body, Moon, frame, first, last, id, degree, Count, states, epochs);
                break;
            case "12":
                SpiceItself.spkw12_c(handle, Body, Moon, frame, first, last, id, degree, Count, states, Begin, Step);
                break;
            case "13":
                SpiceItself.spkw13_c(handle, Body, Moon, frame, first, last, id, degree, Count, states, epochs);
                break;
            default:
                bool isLagrange = words[1] == "Lagrange";
                double[] packets = [.. epochs.SelectMany(time => State(time, hasAcceleration: !isLagrange))];
                SpiceItself.spkw18_c(
                    handle, isLagrange ? 1 : 0, Body, Moon, frame, first, last, id, isLagrange ? 9 : 7, Count, packets, epochs);
                break;
        }
    }

    /// <summary>Six series of six coefficients a record.</summary>
    private static double[] Series()
    {
        Random random = new(3);
        return [.. Enumerable.Range(0, (Count - 1) * 36).Select(i => i % 6 == 0 ? 1800.0 * random.NextDouble() : random.NextDouble())];
    }

    /// <summary>Records that no integrator made; the formula is the same.</summary>
    private static void WriteDifferences(int handle, double[] epochs, int terms, byte[] id)
    {
        Random random = new(terms);
        double[] lines =
        [
            .. epochs.SelectMany(time =>
            {
                double[] s = State(time, hasAcceleration: false);
                int order = 2 + random.Next(terms - 2);
                return (double[])
                [
                    time, .. Enumerable.Range(1, terms).Select(j => 35.0 * j), s[0], s[3], s[1], s[4], s[2], s[5],
                    .. Enumerable.Range(0, 3 * terms).Select(_ => 1e-6 * (random.NextDouble() - 0.5)),
                    order + 1, 1 + random.Next(order), 1 + random.Next(order), order,
                ];
            }),
        ];
        (int body, int center, int count, int size) = (Body, Moon, epochs.Length, (4 * terms) + 11);
        (double first, double last) = (epochs[0], epochs[^1]);
        byte[] frame = "J2000"u8.ToArray();
        if (terms == 15)
        {
            SpiceItself.spkw01_(
                ref handle, ref body, ref center, frame, ref first, ref last, id, ref count, lines, epochs, frame.Length, id.Length - 1);
        }
        else
        {
            SpiceItself.spkw21_(
                ref handle, ref body, ref center, frame, ref first, ref last, id, ref count, ref size, lines, epochs, frame.Length,
                id.Length - 1);
        }
    }
}
