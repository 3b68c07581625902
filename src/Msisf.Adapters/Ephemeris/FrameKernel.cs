using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>Reads frames that frame kernels (FK) define by constant offsets ("TK frames") from a frame that a binary PCK orients.</summary>
/// <remarks>NAIF, Frames Required Reading: "TK frames", "PCK Frames".</remarks>
public static class FrameKernel
{
    private const int PckClass = 2;
    private const int TkClass = 4;

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
            if (pool.Find($"FRAME_{current}") is null)
            {
                throw new BadInputException(
                    $"No frame kernel defines the frame {current} ({string.Join(" -> ", names)}). "
                        + $"Add its frame kernel to the list of kernels.");
            }

            int id = pool.WholeNumber($"FRAME_{current}");
            string classVariable = Variable(pool, "FRAME", id, current, "CLASS");
            variables.AddRange([$"FRAME_{current}", classVariable]);
            switch (pool.WholeNumber(classVariable))
            {
                case PckClass:
                    variables.Add(Variable(pool, "FRAME", id, current, "CLASS_ID"));
                    return new BodyFixedFrame(pool.WholeNumber(variables[^1]), frameFromCurrent);
                case TkClass:
                    string[] items = ["RELATIVE", "SPEC", "MATRIX", "ANGLES", "AXES", "UNITS", "Q"];
                    variables.AddRange(
                        items.Select(item => Variable(pool, "TKFRAME", id, current, item)).Where(item => pool.Find(item) is not null));
                    frameFromCurrent *= ReadRelativeFromFrame(pool, id, current).Transposed;
                    current = pool.Text(Variable(pool, "TKFRAME", id, current, "RELATIVE"));
                    break;
                default:
                    throw new BadInputException(
                        $"{pool.Existing(classVariable).Source}: frame {current} is of class {pool.WholeNumber(classVariable)}; "
                            + $"the built-in reader knows the classes 2 (PCK) and 4 (TK). Use --ephemeris cspice.");
            }
        }
    }

    /// <summary>The constant rotation of a TK frame: from it to the frame that it is relative to.</summary>
    internal static RotationMatrix ReadRelativeFromFrame(KernelPool pool, int id, string name)
    {
        string specification = Variable(pool, "TKFRAME", id, name, "SPEC");
        return pool.Text(specification) switch
        {
            "MATRIX" => ReadMatrix(pool, Variable(pool, "TKFRAME", id, name, "MATRIX")),
            "ANGLES" => ReadAngles(pool, id, name),
            "QUATERNION" => ReadQuaternion(pool, Variable(pool, "TKFRAME", id, name, "Q")),
            string other => throw new BadInputException(
                $"{pool.Existing(specification).Source}: frame {name} is given as {other}; "
                    + $"the built-in reader knows 'MATRIX', 'ANGLES' and 'QUATERNION'. Use --ephemeris cspice."),
        };
    }

    private static RotationMatrix ReadMatrix(KernelPool pool, string matrixVariable)
    {
        IReadOnlyList<double> columns = pool.Numbers(matrixVariable, 9);
        RotationMatrix byColumns = new(
            new Vector3D(columns[0], columns[1], columns[2]),
            new Vector3D(columns[3], columns[4], columns[5]),
            new Vector3D(columns[6], columns[7], columns[8]));
        bool isRotation = IsClose(Vector3D.Cross(byColumns.Row0, byColumns.Row1), byColumns.Row2)
            && IsClose(Vector3D.Cross(byColumns.Row1, byColumns.Row2), byColumns.Row0)
            && IsClose(Vector3D.Cross(byColumns.Row2, byColumns.Row0), byColumns.Row1)
            && Math.Abs(byColumns.Row0.Length - 1.0) <= Tolerances.FrameMatrix;
        return isRotation
            ? byColumns.Transposed
            : throw new BadInputException(
                $"{pool.Existing(matrixVariable).Source}: {matrixVariable} is not a rotation within "
                    + $"{Tolerances.FrameMatrix.ToString("R", CultureInfo.InvariantCulture)}. "
                    + $"Give it more digits, or use --ephemeris cspice.");
    }

    /// <summary>A quaternion of SPICE's, scalar first.</summary>
    private static RotationMatrix ReadQuaternion(KernelPool pool, string variable)
    {
        IReadOnlyList<double> q = pool.Numbers(variable, 4);
        UnitQuaternion turn = UnitQuaternion.FromComponents(q[1], q[2], q[3], q[0], isRounded: true);
        return new RotationMatrix(turn * Vector3D.UnitX, turn * Vector3D.UnitY, turn * Vector3D.UnitZ).Transposed;
    }

    private static bool IsClose(Vector3D u, Vector3D v) => (u - v).Length <= Tolerances.FrameMatrix;

    private static RotationMatrix ReadAngles(KernelPool pool, int id, string name)
    {
        IReadOnlyList<double> angles = pool.Numbers(Variable(pool, "TKFRAME", id, name, "ANGLES"), 3);
        string axesVariable = Variable(pool, "TKFRAME", id, name, "AXES");
        IReadOnlyList<double> axes = pool.Numbers(axesVariable, 3);
        double radiansPerUnit = RadiansPerUnit(pool, Variable(pool, "TKFRAME", id, name, "UNITS"));
        RotationMatrix relativeFromFrame = RotationMatrix.Identity;
        for (int i = 0; i < 3; i++)
        {
            double angle = radiansPerUnit * angles[i];
            relativeFromFrame *= axes[i] switch
            {
                1.0 => RotationMatrix.FrameAboutX(angle),
                2.0 => RotationMatrix.FrameAboutY(angle),
                3.0 => RotationMatrix.FrameAboutZ(angle),
                _ => throw new BadInputException(
                    $"{pool.Existing(axesVariable).Source}: {axesVariable} must be three of the axes 1, 2 and 3."),
            };
        }

        return relativeFromFrame;
    }

    private static double RadiansPerUnit(KernelPool pool, string unitsVariable) => pool.Text(unitsVariable).ToUpperInvariant() switch
    {
        "RADIANS" => 1.0,
        "DEGREES" => Math.PI / 180.0,
        "ARCMINUTES" => Math.PI / 180.0 / 60.0,
        "ARCSECONDS" => Math.PI / 180.0 / 3600.0,
        string other => throw new BadInputException(
            $"{pool.Existing(unitsVariable).Source}: {unitsVariable} is {other}; RADIANS, DEGREES, ARCMINUTES or ARCSECONDS expected."),
    };

    /// <summary>SPICE lets a frame's variables carry its number or its name.</summary>
    internal static string Variable(KernelPool pool, string prefix, int id, string name, string item)
    {
        string byName = $"{prefix}_{name}_{item}";
        return pool.Find(byName) is null ? $"{prefix}_{id}_{item}" : byName;
    }
}
