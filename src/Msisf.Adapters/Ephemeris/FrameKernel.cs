using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>Reads frames that frame kernels (FK) define by constant offsets ("TK frames") from a frame that a binary PCK orients.</summary>
/// <remarks>NAIF, Frames Required Reading: "TK frames", "PCK Frames".</remarks>
public static class FrameKernel
{
    /// <summary>Follows a frame's definition down to the PCK frame that it is based on.</summary>
    /// <param name="pool">Holds the frame kernels.</param>
    /// <param name="name">The frame, e.g. "MOON_ME".</param>
    /// <exception cref="BadInputException">The frame is not defined, defined by itself, or of a kind that can't be read.</exception>
    public static BodyFixedFrame ReadBodyFixedFrame(KernelPool pool, string name) => ReadBodyFixedFrame(pool, name, []);

    /// <inheritdoc cref="ReadBodyFixedFrame(KernelPool, string)"/>
    /// <param name="pool">Holds the frame kernels.</param>
    /// <param name="name">The frame, e.g. "MOON_ME".</param>
    /// <param name="variables">Gets the names of the variables that define it.</param>
    internal static BodyFixedFrame ReadBodyFixedFrame(KernelPool pool, string name, List<string> variables)
    {
        RotationMatrix frameFromCurrent = RotationMatrix.Identity;
        List<string> names = [];
        string current = name;
        while (true)
        {
            if (names.Contains(current))
            {
                throw new BadInputException(
                    $"{pool.Existing($"FRAME_{current}").Source}: frame {name} is defined by itself: "
                        + $"{string.Join(" -> ", names)} -> {current}.");
            }

            names.Add(current);
            FrameDefinition frame = FrameDefinition.Find(pool, current) ?? throw new BadInputException(
                $"No frame kernel defines the frame {current} ({string.Join(" -> ", names)}). "
                    + $"Add its frame kernel to the list of kernels.");
            variables.AddRange(frame.Variables);
            switch (frame.Class)
            {
                case FrameDefinition.PckClass:
                    return new BodyFixedFrame(frame.ClassId, frameFromCurrent);
                case FrameDefinition.TkClass:
                    frameFromCurrent *= frame.RelativeFromFrame().Transposed;
                    current = frame.Relative;
                    break;
                default:
                    throw new BadInputException(
                        $"{pool.Existing($"FRAME_{current}").Source}: frame {current} is of class {frame.Class}; "
                            + $"the built-in reader knows the classes 2 (PCK) and 4 (TK). Use --ephemeris cspice.");
            }
        }
    }
}

/// <summary>What text kernels say of one frame.</summary>
/// <param name="Pool">Holds the frame kernels.</param>
/// <param name="Name">The frame, in capitals.</param>
/// <param name="Id">NAIF's number of the frame.</param>
/// <remarks>NAIF, Frames Required Reading. SPICE lets variables carry a frame's number or its name.</remarks>
internal sealed record FrameDefinition(KernelPool Pool, string Name, int Id)
{
    public const int PckClass = 2;
    public const int CkClass = 3;
    public const int TkClass = 4;

    private static readonly string[] TkItems = ["RELATIVE", "SPEC", "MATRIX", "ANGLES", "AXES", "UNITS", "Q"];

    private static readonly (string Name, double Radians)[] Units =
    [
        ("RADIANS", 1.0), ("DEGREES", Math.PI / 180.0), ("ARCMINUTES", Math.PI / 180.0 / 60.0), ("ARCSECONDS", Math.PI / 180.0 / 3600.0),
        ("HOURANGLE", Math.PI / 12.0), ("MINUTEANGLE", Math.PI / 12.0 / 60.0), ("SECONDANGLE", Math.PI / 12.0 / 3600.0),
    ];

    /// <summary>How it is defined: one of the constants, or another class of SPICE's.</summary>
    public int Class => Pool.WholeNumber(OfFrame("CLASS"));

    /// <summary>The number under which its data are: of a PCK's orientation, of a CK's instrument, of a TK frame's variables.</summary>
    public int ClassId => Pool.WholeNumber(OfFrame("CLASS_ID"));

    /// <summary>The frame that a TK frame is turned from.</summary>
    public string Relative => Pool.Text(OfTk("RELATIVE")).Trim().ToUpperInvariant();

    /// <summary>The names of the variables that define it.</summary>
    public IEnumerable<string> Variables =>
    [
        $"FRAME_{Name}", OfFrame("CLASS"), OfFrame("CLASS_ID"),
        .. Class == TkClass ? TkItems.Select(OfTk).Where(variable => Pool.Find(variable) is not null) : [],
    ];

    /// <summary>Looks a frame up.</summary>
    /// <param name="pool">Holds the frame kernels.</param>
    /// <param name="name">Its name; case does not matter.</param>
    /// <returns>Null if no kernel defines it.</returns>
    public static FrameDefinition? Find(KernelPool pool, string name)
    {
        string capitals = name.Trim().ToUpperInvariant();
        return pool.Find($"FRAME_{capitals}") is null ? null : new FrameDefinition(pool, capitals, pool.WholeNumber($"FRAME_{capitals}"));
    }

    /// <summary>The name that kernels give a frame's number; null if none does.</summary>
    public static string? NameOf(KernelPool pool, int number)
    {
        string variable = Invariant($"FRAME_{number}_NAME");
        return pool.Find(variable) is null ? null : pool.Text(variable).Trim().ToUpperInvariant();
    }

    /// <summary>The constant rotation of a TK frame: from it to the frame that it is relative to.</summary>
    /// <exception cref="BadInputException">It is not given, or in a way that is not known.</exception>
    public RotationMatrix RelativeFromFrame()
    {
        string specification = OfTk("SPEC");
        return Pool.Text(specification).Trim().ToUpperInvariant() switch
        {
            "MATRIX" => ReadMatrix(OfTk("MATRIX")),
            "ANGLES" => ReadAngles(),
            "QUATERNION" => ReadQuaternion(OfTk("Q")),
            string other => throw new BadInputException(
                $"{Pool.Existing(specification).Source}: frame {Name} is given as {other}; "
                    + $"the built-in reader knows 'MATRIX', 'ANGLES' and 'QUATERNION'. Use --ephemeris cspice."),
        };
    }

    private string OfFrame(string item) => Variable("FRAME", Id, Name, item);

    /// <summary>A TK frame's data are under its class ID, or under the name of the frame that has this number.</summary>
    private string OfTk(string item) => Variable("TKFRAME", ClassId, ClassId == Id ? Name : NameOf(Pool, ClassId), item);

    private string Variable(string prefix, int id, string? name, string item)
    {
        string byNumber = Invariant($"{prefix}_{id}_{item}");
        return Pool.Find(byNumber) is null && name is not null && Pool.Find($"{prefix}_{name}_{item}") is not null
            ? $"{prefix}_{name}_{item}"
            : byNumber;
    }

    /// <summary>Like SPICE, makes a matrix of rounded numbers orthogonal: its first column is kept, then the third made.</summary>
    private RotationMatrix ReadMatrix(string matrixVariable)
    {
        IReadOnlyList<double> columns = Pool.Numbers(matrixVariable, 9);
        Vector3D[] given = [.. columns.Chunk(3).Select(column => new Vector3D(column[0], column[1], column[2]))];
        Vector3D x = given[0];
        Vector3D z = Vector3D.Cross(given[0], given[1]);
        bool isRotation = Math.Abs(x.Length - 1.0) <= Tolerances.PrintedMatrix && Math.Abs(z.Length - 1.0) <= Tolerances.PrintedMatrix
            && (z - given[2]).Length <= Tolerances.PrintedMatrix
            && (Vector3D.Cross(z, x) - given[1]).Length <= Tolerances.PrintedMatrix;
        return isRotation
            ? new RotationMatrix(x.Normalized(), Vector3D.Cross(z, x).Normalized(), z.Normalized()).Transposed
            : throw new BadInputException(
                $"{Pool.Existing(matrixVariable).Source}: {matrixVariable} is not a rotation within "
                    + $"{Tolerances.PrintedMatrix.ToString("R", CultureInfo.InvariantCulture)}. Check its nine numbers.");
    }

    private RotationMatrix ReadQuaternion(string variable)
    {
        double[] q = [.. Pool.Numbers(variable, 4)];
        return SpiceQuaternion.ToMatrix(q)
            ?? throw new BadInputException($"{Pool.Existing(variable).Source}: {variable} has no length. Check its four numbers.");
    }

    private RotationMatrix ReadAngles()
    {
        IReadOnlyList<double> angles = Pool.Numbers(OfTk("ANGLES"), 3);
        string axesVariable = OfTk("AXES");
        IReadOnlyList<double> axes = Pool.Numbers(axesVariable, 3);
        double radiansPerUnit = RadiansPerUnit(OfTk("UNITS"));
        RotationMatrix relativeFromFrame = RotationMatrix.Identity;
        for (int i = 0; i < 3; i++)
        {
            relativeFromFrame *= axes[i] is 1.0 or 2.0 or 3.0
                ? RotationMatrix.FrameAbout((int)axes[i], radiansPerUnit * angles[i])
                : throw new BadInputException(
                    $"{Pool.Existing(axesVariable).Source}: {axesVariable} must be three of the axes 1, 2 and 3.");
        }

        return relativeFromFrame;
    }

    private double RadiansPerUnit(string unitsVariable)
    {
        string unit = Pool.Text(unitsVariable).Trim().ToUpperInvariant();
        return Units.FirstOrDefault(known => known.Name == unit) is { Name: not null } found
            ? found.Radians
            : throw new BadInputException(
                $"{Pool.Existing(unitsVariable).Source}: {unitsVariable} is {unit}; {string.Join(", ", Units.Select(known => known.Name))} "
                    + "are known.");
    }
}

/// <summary>Quaternions as SPICE has them: scalar first, of any length but 0.</summary>
internal static class SpiceQuaternion
{
    /// <summary>The matrix of a quaternion (SPICE's q2m); null if it has no length.</summary>
    public static RotationMatrix? ToMatrix(ReadOnlySpan<double> q)
    {
        double length = double.Hypot(double.Hypot(q[0], q[1]), double.Hypot(q[2], q[3]));
        if (!(length > 0.0 && double.IsFinite(length)))
        {
            return null;
        }

        (double w, double x, double y, double z) = (q[0] / length, q[1] / length, q[2] / length, q[3] / length);
        return new RotationMatrix(
            new Vector3D(1.0 - (2.0 * ((y * y) + (z * z))), 2.0 * ((x * y) - (w * z)), 2.0 * ((x * z) + (w * y))),
            new Vector3D(2.0 * ((x * y) + (w * z)), 1.0 - (2.0 * ((x * x) + (z * z))), 2.0 * ((y * z) - (w * x))),
            new Vector3D(2.0 * ((x * z) - (w * y)), 2.0 * ((y * z) + (w * x)), 1.0 - (2.0 * ((x * x) + (y * y)))));
    }
}
