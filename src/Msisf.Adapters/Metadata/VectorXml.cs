namespace Msisf.Adapters.Metadata;

/// <summary>The elements of a meta file that hold a vector or a rotation.</summary>
internal static class VectorXml
{
    public static string Of(Vector3D v, LongEDigits digits) =>
        $"""<Vector3D x="{LongE.ToText(v.X, digits)}" y="{LongE.ToText(v.Y, digits)}" z="{LongE.ToText(v.Z, digits)}" />""";

    /// <summary>A rotation, the real part first.</summary>
    public static string Of(UnitQuaternion q, LongEDigits digits) =>
        $"<Quaternion r=\"{LongE.ToText(q.W, digits)}\" x=\"{LongE.ToText(q.X, digits)}\" "
            + $"y=\"{LongE.ToText(q.Y, digits)}\" z=\"{LongE.ToText(q.Z, digits)}\" />";
}
